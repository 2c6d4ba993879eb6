#include "judge/explain/agreement.hpp"

#include <algorithm>

#include "judge/explain/causes.hpp"

namespace atelier::judge {
namespace {

bool is_probe(const JudgedCase& c) {
  return c.profile == Profile::values;
}

bool could_be(const CaseResult& result, const std::string& mistake) {
  return std::find(result.could_be.begin(), result.could_be.end(), mistake) != result.could_be.end();
}

/// Whether there is enough to see in an answer.
bool is_plain(const CaseResult& result) {
  const auto over = result.figures.find("over");
  return over == result.figures.end() || over->second >= min_failing_pixels;
}

}  // namespace

Agreement::Agreement(const std::vector<CaseResult>& results, const std::vector<JudgedCase>& cases,
                     const StepReferences& references)
    : results_(results), cases_(cases), references_(references) {}

Agreement::Witness Agreement::witness(const std::string& mistake, std::size_t index) const {
  const CaseResult& result = results_[index];
  if (result.status != Status::passed && result.status != Status::failed) return Witness::none;
  if (is_probe(cases_[index])) {
    if (!references_.atlas(cases_[index]).values.mistakes.contains(mistake)) return Witness::none;
    return could_be(result, mistake) ? Witness::agrees : Witness::contradicts;
  }
  if (result.status != Status::passed) return Witness::none;  // other mistakes may hide it
  const auto& pictures = references_.atlas(cases_[index]).pictures;
  const bool would_change = std::any_of(pictures.begin(), pictures.end(),
                                        [&](const AtlasPicture& entry) { return entry.mistake == mistake; });
  return would_change ? Witness::contradicts : Witness::none;
}

Agreement::Witness Agreement::witness(const std::string& mistake) const {
  Witness all = Witness::none;
  for (std::size_t i = 0; i < results_.size(); ++i) {
    const Witness one = witness(mistake, i);
    if (one == Witness::contradicts) return one;
    if (one == Witness::agrees) all = one;
  }
  return all;
}

std::string Agreement::name_of(std::size_t index, bool waits) const {
  const CaseResult& result = results_[index];
  if (result.status != Status::failed || result.unwritten || !is_plain(result)) return {};
  std::string name;
  for (const std::string& mistake : result.could_be) {
    const Witness others = witness(mistake);
    if (others == Witness::contradicts || (waits && others == Witness::none)) continue;
    if (!name.empty()) return {};
    name = mistake;
  }
  return name;
}

}  // namespace atelier::judge
