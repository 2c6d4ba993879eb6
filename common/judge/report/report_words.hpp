// What every report says, in the same words and the same order; how it looks is each report's own business.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "judge/compare/result.hpp"

namespace atelier::judge {

/// Points as people write them: "2", "1.75"; at most two decimals, cut rather than rounded so that nobody reads 2/2
/// beside a failed case.
std::string points_text(double points);

/// "2 / 3 points"
std::string score_text(double score, double max_score);

/// "build failed" for people, where to_string gives "build_failed" for programs.
std::string status_words(Status status);

/// "pixel (12, 40): yours 255 0 0, reference 12 12 12"
std::string worst_words(const Worst& worst);

/// One thing that a verdict says.
struct Remark {
  std::string label;  ///< "asked", "seen", "looks like", "where", "credit", "try next", "again"
  std::string text;   ///< as it came: escape it
};

/// The remarks of a case in the order in which a student needs them, without the empty ones.
std::vector<Remark> remarks(const CaseResult& result);

/// Cases that a report tells of in one go, in the order of the step: those without an answer for the same reason (files
/// that do not build, a program that does not start), or one case alone.
using CaseGroup = std::vector<const CaseResult*>;
std::vector<CaseGroup> case_groups(const StepResult& step);

/// The remarks that all cases of a group have in common, in order; of one case alone, all of them. "again" is that of
/// the first case: one is enough to see it.
std::vector<Remark> remarks(const CaseGroup& group);

/// "41 cases"
std::string cases_words(const CaseGroup& group);

/// "sphere, teapot, look-at"
std::string case_names(const CaseGroup& group);

/// The points of a group together.
struct Points {
  double score = 0, max_score = 0;
};
Points sum_of(const CaseGroup& group);

/// What the program printed in the first case of the group in which it printed anything.
std::string output_of(const CaseGroup& group);

/// How many of the cases have this status.
int count(const StepResult& step, Status status);

/// A name that is unique in a report and safe in URLs and HTML: "02-blinn-phong.sphere".
std::string case_anchor(const StepResult& step, const CaseResult& result);

/// Text for HTML and XML, as content or inside quotes: printable (base/printable.hpp) with & < > " ' as references.
/// Lines stay lines. Nothing that it returns can end a tag, an attribute or a comment.
std::string escape_markup(std::string_view text);

}  // namespace atelier::judge
