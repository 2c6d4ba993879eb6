#include "judge/explain/agreement.hpp"

#include <algorithm>
#include <set>

#include "judge/explain/causes.hpp"

namespace atelier::judge {
namespace {

bool is_probe(const JudgedCase& c) {
  return c.profile == Profile::values;
}

std::string asked_first(const JudgedCase& c) {
  return c.functions.empty() ? std::string() : c.functions.front();
}

/// The known mistakes that an answer could be, each once.
std::set<std::string> mistakes_of(const CaseResult& result) {
  std::set<std::string> mistakes;
  for (const std::string& form : result.could_be) mistakes.insert(mistake_of_form(form));
  return mistakes;
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

Agreement::Witness Agreement::witness(const std::string& mistake, const std::string& function,
                                      std::size_t index) const {
  const CaseResult& result = results_[index];
  if (result.status != Status::passed && result.status != Status::failed) return Witness::none;
  if (is_probe(cases_[index])) {
    bool known = false, unseen = false;  // by the probe
    for (const auto& [form, answer] : references_.atlas(cases_[index]).values.mistakes) {
      if (mistake_of_form(form) != mistake) continue;
      known = true;
      unseen = unseen || answer.empty();
    }
    if (result.status == Status::passed && (!known || unseen)) return Witness::none;
    if (!known)
      return !function.empty() && asked_first(cases_[index]) == function ? Witness::contradicts : Witness::none;
    return mistakes_of(result).contains(mistake) ? Witness::agrees : Witness::contradicts;
  }
  if (result.status != Status::passed) return Witness::none;                    // other mistakes may hide it
  const std::vector<std::string>& shows = references_.of(cases_[index]).shows;  // need not decode the atlas
  const bool would_change = std::find(shows.begin(), shows.end(), mistake) != shows.end();
  return would_change ? Witness::contradicts : Witness::none;
}

bool Agreement::could_be_patch(const std::string& mistake, std::size_t index) const {
  const CaseResult& result = results_[index];
  if (result.status != Status::passed && result.status != Status::failed) return true;
  const auto& known = references_.atlas(cases_[index]).values.mistakes;
  const auto patch = known.find(mistake);
  if (patch == known.end()) return true;
  if (patch->second.empty()) return result.status == Status::passed;
  return std::find(result.could_be.begin(), result.could_be.end(), mistake) != result.could_be.end();
}

Agreement::Witness Agreement::witness(const std::string& mistake, const std::string& function) const {
  Witness probes = Witness::none, pictures = Witness::none;
  bool as_drawn = true;  // the pictures of mistakes are those of their patches, not of other spellings
  for (std::size_t i = 0; i < results_.size(); ++i) {
    const Witness one = witness(mistake, function, i);
    if (!is_probe(cases_[i])) {
      if (one != Witness::none) pictures = one;
      continue;
    }
    if (one == Witness::contradicts) return one;
    if (one == Witness::agrees) probes = one;
    as_drawn = as_drawn && could_be_patch(mistake, i);
  }
  return pictures == Witness::contradicts && as_drawn ? pictures : probes;
}

std::string Agreement::name_of(std::size_t index, bool waits) const {
  const CaseResult& result = results_[index];
  if (result.status != Status::failed || result.unwritten || !is_plain(result)) return {};
  std::string name;
  const std::string function = is_probe(cases_[index]) ? asked_first(cases_[index]) : std::string();
  for (const std::string& mistake : mistakes_of(result)) {
    const Witness others = witness(mistake, function);
    if (others == Witness::contradicts || (waits && others == Witness::none)) continue;
    if (!name.empty()) return {};
    name = mistake;
  }
  return name;
}

}  // namespace atelier::judge
