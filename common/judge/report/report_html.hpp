// The HTML report: one file with all pictures.
#pragma once

#include <filesystem>
#include <string>

#include "judge/compare/result.hpp"

namespace atelier::judge {

/// A self-contained page: its content security policy forbids loading anything else. Every text of the result is
/// escaped (escape_markup in report_words.hpp), since output and build logs are untrusted. Pictures are embedded PNGs;
/// see report_pictures. The ids of cases come from case_anchor.
std::string html_report(const SubmissionResult& result);

/// A report's page with `text` in place of the comment that it has; empty: without one. A page with no place for a
/// comment is unchanged.
std::string with_comment(const std::string& page, const std::string& text);

/// Throws Error naming the file if it cannot be written; the old file is then unchanged.
void write_html_report(const std::filesystem::path& file, const SubmissionResult& result);

}  // namespace atelier::judge
