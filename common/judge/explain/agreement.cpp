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

Agreement::Witness Agreement::witness(const std::string& form, std::size_t index) const {
  const CaseResult& result = results_[index];
  if (result.status != Status::passed && result.status != Status::failed) return Witness::none;
  if (is_probe(cases_[index])) {
    const auto& known = references_.atlas(cases_[index]).values.mistakes;
    const auto found = known.find(form);
    if (found == known.end() || found->second.empty()) return Witness::none;
    return could_be(result, form) ? Witness::agrees : Witness::contradicts;
  }
  if (result.status != Status::passed) return Witness::none;                    // other mistakes may hide it
  const std::vector<std::string>& shows = references_.of(cases_[index]).shows;  // need not decode the atlas
  const bool would_change = std::find(shows.begin(), shows.end(), mistake_of_form(form)) != shows.end();
  return would_change ? Witness::contradicts : Witness::none;
}

Agreement::Witness Agreement::witness(const std::string& form) const {
  Witness all = Witness::none;
  for (std::size_t i = 0; i < results_.size(); ++i) {
    const Witness one = witness(form, i);
    if (one == Witness::contradicts) return one;
    if (one == Witness::agrees) all = one;
  }
  return all;
}

std::vector<std::string> Agreement::forms_of(std::size_t index) const {
  std::vector<std::string> forms = results_[index].could_be;
  if (is_probe(cases_[index])) return forms;
  for (const std::string& mistake : results_[index].could_be) {
    const bool has_other = std::any_of(cases_.begin(), cases_.end(), [&](const JudgedCase& c) {
      return is_probe(c) && references_.atlas(c).values.mistakes.contains(other_form(mistake));
    });
    if (has_other) forms.push_back(other_form(mistake));
  }
  return forms;
}

std::string Agreement::name_of(std::size_t index, bool waits) const {
  const CaseResult& result = results_[index];
  if (result.status != Status::failed || result.unwritten || !is_plain(result)) return {};
  std::string name;
  for (const std::string& form : forms_of(index)) {
    const Witness others = witness(form);
    if (others == Witness::contradicts || (waits && others == Witness::none)) continue;
    if (!name.empty() && name != mistake_of_form(form)) return {};
    name = mistake_of_form(form);
  }
  return name;
}

}  // namespace atelier::judge
