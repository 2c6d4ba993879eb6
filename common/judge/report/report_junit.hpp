// JUnit XML, which continuous integration and course platforms show as a list of tests.
#pragma once

#include <filesystem>
#include <string>

#include "judge/compare/result.hpp"

namespace atelier::judge {

/// One <testsuite> per step, one <testcase> per case. A wrong or missing answer is a <failure>; a crash, a time-out and
/// a failed build are an <error>. Points are in <properties> and, because most readers ignore those, in the text.
/// Always valid XML 1.0 in UTF-8.
std::string junit_xml(const SubmissionResult& result);

/// Throws Error naming the file if it cannot be written; the old file is then unchanged.
void write_junit_xml(const std::filesystem::path& file, const SubmissionResult& result);

}  // namespace atelier::judge
