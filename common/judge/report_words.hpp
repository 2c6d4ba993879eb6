// What every report says, in the same words and the same order; how it looks is each report's own business.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "judge/result.hpp"

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

/// How many of the cases have this status.
int count(const StepResult& step, Status status);

/// A name that is unique in a report and safe in URLs and HTML: "02-blinn-phong.sphere".
std::string case_anchor(const StepResult& step, const CaseResult& result);

/// Text for HTML and XML, as content or inside quotes: printable (case/printable.hpp) with & < > " ' as references.
/// Lines stay lines. Nothing that it returns can end a tag, an attribute or a comment.
std::string escape_markup(std::string_view text);

}  // namespace atelier::judge
