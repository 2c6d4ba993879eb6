// JUnit XML: what continuous integration and course platforms show as a list of tests.
#pragma once

#include <filesystem>
#include <string>

#include "judge/compare/result.hpp"

namespace atelier::judge {

/// One <testsuite> a step, one <testcase> a case. A wrong or missing answer is a <failure>; a crash, a time-out and a
/// failed build are an <error>. Points stand in <properties> and, because most readers skip those, in the text.
/// Valid XML 1.0 in UTF-8, whatever the texts hold.
std::string junit_xml(const SubmissionResult& result);

/// Throws Error naming the file where it cannot be written; what stood there stays then.
void write_junit_xml(const std::filesystem::path& file, const SubmissionResult& result);

}  // namespace atelier::judge
