// The report that an instructor reads and a student keeps: one HTML file, pictures and all.
#pragma once

#include <filesystem>
#include <string>

#include "judge/compare/result.hpp"

namespace atelier::judge {

/// A self-contained page: nothing is loaded from elsewhere, and its content security policy forbids it to be. Every
/// text of the result is escaped (judge/report/report_words.hpp), student's output and build logs above all. Pictures
/// are embedded PNGs; see report_pictures. Cases stand under the ids that case_anchor gives.
std::string html_report(const SubmissionResult& result);

/// Throws Error naming the file where it cannot be written; what stood there stays then.
void write_html_report(const std::filesystem::path& file, const SubmissionResult& result);

}  // namespace atelier::judge
