// The texts that all reports share, in the same words and order; each report formats them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "judge/compare/result.hpp"

namespace atelier::judge {

/// "2", "1.75": at most two decimals, rounded down so that a failed case never shows 2/2.
std::string points_text(double points);

/// "2 / 3 points"
std::string score_text(double score, double max_score);

/// "build failed", for display; to_string gives "build_failed", for programs.
std::string status_words(Status status);

/// "pixel (12, 40): yours 255 0 0, reference 12 12 12"
std::string worst_words(const Worst& worst);

/// One part of a verdict.
struct Remark {
  std::string label;  ///< "expected", "found", "looks like", "where", "credit", "try next", "rerun", "waits for"
  std::string text;   ///< not escaped
};

/// The remarks of a case in the order above, without empty ones.
std::vector<Remark> remarks(const CaseResult& result);

/// Cases that are reported together: those without an answer for the same reason (files that do not build, a program
/// that does not start), or a single case. In the order of the step.
using CaseGroup = std::vector<const CaseResult*>;
std::vector<CaseGroup> case_groups(const StepResult& step);

/// The remarks that all cases of a group have in common, in order; for a single case all remarks. "rerun" is always
/// that of the first case.
std::vector<Remark> remarks(const CaseGroup& group);

/// What to correct, the `index`-th of a step: "Begin with pcf: wrong for 4 of 9 inputs; 12 failing cases need it".
std::string headline(const StepResult& step, std::size_t index);

/// What is said of a cause: the remarks of the case that shows it best, then "also wrong" (its other probes, or
/// pictures of the same kind), "seen in" (a picture), "may be in" (functions without a probe), "waiting" (other cases).
std::vector<Remark> remarks(const StepResult& step, const Cause& cause);

/// All cases of a cause without an answer.
CaseGroup shown_group(const StepResult& step, const Cause& cause);

/// The case that shows a cause best.
const CaseResult& shown_case(const StepResult& step, const Cause& cause);

/// "sphere, teapot and 29 more": the first `most` names.
std::string some_names(const std::vector<std::string>& names, std::size_t most = 12);

/// "41 cases"
std::string cases_words(std::size_t number);

/// "31 of 48 cases passed", "All 48 cases passed"
std::string passed_words(std::size_t passed, std::size_t cases);
std::string passed_words(const StepResult& step);

/// "sphere, teapot, look-at"
std::string case_names(const CaseGroup& group);

/// The sum of a group's points.
struct Points {
  double score = 0, max_score = 0;
};
Points sum_of(const CaseGroup& group);

/// The program's output in the group's first case with any output.
std::string output_of(const CaseGroup& group);

/// How many of the cases have this status.
int count(const StepResult& step, Status status);

/// A name as part of an id and of an address: ASCII letters, digits, - and _ stay, any other byte becomes ~ and two
/// hexadecimal digits. Different names give different texts.
std::string anchor_text(std::string_view name);

/// The place of a case in an HTML report, for report.html#PLACE: "case-sphere"; among several steps
/// "case-02-blinn-phong.sphere", since steps may have cases of the same name.
enum class StepsInReport { one, several };
StepsInReport steps_in(const SubmissionResult& result);
std::string case_anchor(const StepResult& step, const CaseResult& result, StepsInReport steps);

/// The end of the address of a report: "#" and the place of the case to begin with; empty if all have passed.
std::string place_to_begin(const SubmissionResult& result);

/// Escapes text for HTML and XML content and quoted attributes: makes it printable (base/printable.hpp), keeps line
/// breaks, and replaces & < > " ' by character references.
std::string escape_markup(std::string_view text);

}  // namespace atelier::judge
