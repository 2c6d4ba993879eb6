// The results of a class as JUnit XML: a <testsuite> per student, a <testcase> per step.
#pragma once

#include <string>

#include "grade/results/class_results.hpp"

namespace atelier::grade {

/// A step with fewer points than possible is a <failure>, one that does not compile an <error>, one that was not handed
/// in or not touched is <skipped>. Always valid XML 1.0 in UTF-8.
std::string class_junit_xml(const ClassResults& results);

}  // namespace atelier::grade
