#include "judge/explain/causes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

#include "judge/explain/agreement.hpp"

namespace atelier::judge {
namespace {

using Indices = std::vector<std::size_t>;

struct Function {
  std::string name;
  Indices probes;               ///< the cases that ask it
  std::optional<bool> wrong{};  ///< none: not yet decided
  bool unwritten = false;       ///< all its failing probes return what the skeleton returns
};

class CauseFinder {
 public:
  CauseFinder(StepResult& step, const std::vector<JudgedCase>& cases, const StepReferences& references)
      : step_(step), cases_(cases), references_(references) {
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      needs_.push_back(needs_of(i));
      if (const std::string name = asked_function(i); !name.empty()) {
        Function* known = find(name);
        if (known == nullptr) known = &functions_.emplace_back(Function{.name = name});
        known->probes.push_back(i);
      }
    }
    for (Function& function : functions_) decide(function);
  }

  void find_causes() {
    step_.causes.clear();
    add_cases_without_answer();
    std::map<const Function*, Indices> failing;
    Indices others;
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      if (!is_failing(step_.cases[i])) continue;
      if (const Function* culprit = culprit_of(i))
        failing[culprit].push_back(i),
            step_.cases[i].waits_for = asked_function(i) == culprit->name ? "" : culprit->name;
      else
        others.push_back(i);
    }
    name_mistakes();
    for (const Function& function : functions_)
      if (failing.contains(&function) && !function.unwritten) add_function(function, failing.at(&function));
    const auto choices =
        std::stable_partition(others.begin(), others.end(), [&](std::size_t i) { return !cases_[i].choice; });
    add_pictures({others.begin(), choices});
    add_unwritten(failing);
    for (auto i = choices; i != others.end(); ++i) step_.causes.push_back({.kind = Cause::Kind::choice, .shown = {*i}});
    put_unasked_last();
  }

 private:
  Function* find(const std::string& name) {
    const auto found =
        std::find_if(functions_.begin(), functions_.end(), [&](const Function& f) { return f.name == name; });
    return found == functions_.end() ? nullptr : &*found;
  }

  /// The function that a probe asks; empty for a picture, and for a probe that asks several together.
  std::string asked_function(std::size_t i) const {
    const JudgedCase& c = cases_[i];
    return c.profile == Profile::values && !c.functions.empty() && !c.together ? c.functions.front() : "";
  }

  std::vector<std::string> needs_of(std::size_t i) const {
    std::vector<std::string> needs = references_.of(cases_[i]).needs;
    if (needs.empty()) needs = cases_[i].functions;
    // What the skeleton's function returns may be right for this probe.
    if (const std::string asked = asked_function(i); !asked.empty()) needs.push_back(asked);
    return needs;
  }

  bool decide(Function& function) {
    if (function.wrong) return *function.wrong;
    function.wrong = false;  // while its probes are looked at: functions may need each other
    bool wrong = false, unwritten = true;
    for (const std::size_t i : function.probes) {
      if (!is_failing(step_.cases[i]) || needs_other_wrong_function(i, function)) continue;
      wrong = true;
      unwritten = unwritten && step_.cases[i].unwritten;
    }
    function.unwritten = wrong && unwritten;
    function.wrong = wrong;
    return wrong;
  }

  bool is_failing(const CaseResult& result) const { return result.status != Status::passed && !has_no_answer(result); }

  /// Not built, or without an answer for the same reason as most cases: then it is no single function.
  bool has_no_answer(const CaseResult& result) const {
    if (result.status == Status::build_failed) return true;
    if (result.status == Status::passed || result.status == Status::failed) return false;
    const auto alike = std::count_if(step_.cases.begin(), step_.cases.end(), [&](const CaseResult& other) {
      return other.status == result.status && other.reason == result.reason;
    });
    return std::size_t(2 * alike) > step_.cases.size() && step_.cases.size() > 1;
  }

  bool needs_other_wrong_function(std::size_t i, const Function& function) {
    for (const std::string& name : needs_[i])
      if (Function* other = find(name); other != nullptr && other != &function && decide(*other)) return true;
    return false;
  }

  /// The wrong function that a failing case needs: written ones first, then the first in order.
  const Function* culprit_of(std::size_t i) const {
    const std::vector<std::string>& needed = needs_[i];
    const Function* culprit = nullptr;
    for (const Function& function : functions_) {
      if (!*function.wrong || std::find(needed.begin(), needed.end(), function.name) == needed.end()) continue;
      if (culprit == nullptr || (culprit->unwritten && !function.unwritten)) culprit = &function;
    }
    return culprit;
  }

  void add_cases_without_answer() {
    std::map<std::string, std::size_t> cause_of;  // by reason
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      const CaseResult& result = step_.cases[i];
      if (result.status == Status::passed || !has_no_answer(result)) continue;
      const auto [place, is_new] = cause_of.try_emplace(result.reason, step_.causes.size());
      if (is_new) step_.causes.push_back({.kind = Cause::Kind::no_answer});
      step_.causes[place->second].shown.push_back(i);
    }
  }

  /// Cases that were not asked because others took too long wait for these.
  void put_unasked_last() {
    const auto timed_out = [&](const Cause& cause) {
      return step_.cases[cause.shown.empty() ? cause.waiting.front() : cause.shown.front()].status == Status::timeout;
    };
    const auto first =
        std::ranges::find_if(step_.causes, [](const Cause& cause) { return cause.kind != Cause::Kind::no_answer; });
    const bool others_timed_out = std::ranges::any_of(first, step_.causes.end(), timed_out);
    if (others_timed_out && first != step_.causes.begin() && timed_out(step_.causes.front()))
      std::rotate(step_.causes.begin(), first, step_.causes.end());
  }

  void name_mistakes() {
    const Agreement agreement(step_.cases, cases_, references_);
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      CaseResult& result = step_.cases[i];
      const bool waits = !result.waits_for.empty();
      if (waits) drop_hypothesis(result, cases_[i]);
      if (const std::string name = agreement.name_of(i, waits); !name.empty())
        set_name(result, name);
      else if (result.evidence)
        result.evidence->mistake.reset();
      if (waits && !result.mistake)
        result.hint = fmt::format("Correct {} first: this case needs it.", result.waits_for);
    }
  }

  static void drop_hypothesis(CaseResult& result, const JudgedCase& c) {
    if (!result.hypothesis) return;
    result.hypothesis.reset();
    result.reason = result.measured;
    result.hint = c.hint;
  }

  void set_name(CaseResult& result, const std::string& name) const {
    result.mistake = name;
    const Mistake* known = references_.mistake(name);
    if (known == nullptr) return;
    result.mistake_sentence = known->sentence;
    if (!known->hint.empty()) result.hint = known->hint;
  }

  void add_function(const Function& function, const Indices& failing) {
    Cause cause{.kind = Cause::Kind::function, .functions = {function.name}};
    for (const std::size_t i : function.probes) {
      const auto& figures = step_.cases[i].figures;
      const auto inputs = int(cases_[i].ask.inputs.size());
      cause.inputs += inputs;
      if (is_failing(step_.cases[i])) cause.wrong += figures.contains("wrong") ? int(figures.at("wrong")) : inputs;
    }
    for (const std::size_t i : failing) (asked_function(i) == function.name ? cause.shown : cause.waiting).push_back(i);
    sort_by_clarity(cause.waiting);
    step_.causes.push_back(std::move(cause));
  }

  /// Pictures first, those that need few functions first, then those with many failing pixels.
  void sort_by_clarity(Indices& indices) const {
    const auto rank = [&](std::size_t i) {
      const auto share = step_.cases[i].figures.find("share");
      const bool picture = share != step_.cases[i].figures.end();
      return std::tuple(!picture, needs_[i].size(), picture ? -share->second : 0);
    };
    std::stable_sort(indices.begin(), indices.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  }

  /// One cause for each mistake that is named, and one for all that have no name.
  void add_pictures(Indices others) {
    sort_by_clarity(others);
    std::vector<std::pair<std::string, Indices>> groups;
    for (const std::size_t i : others) {
      const std::string name = step_.cases[i].mistake.value_or("");
      const auto found = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == name; });
      (found == groups.end() ? groups.emplace_back(name, Indices{}) : *found).second.push_back(i);
    }
    for (auto& [name, indices] : groups) {
      Cause cause{.kind = Cause::Kind::picture, .functions = functions_without_probe(indices)};
      cause.shown = {indices.front()};
      cause.waiting.assign(indices.begin() + 1, indices.end());
      step_.causes.push_back(std::move(cause));
    }
  }

  /// The functions that no probe asks and that all these cases need.
  std::vector<std::string> functions_without_probe(const Indices& indices) {
    std::vector<std::string> common;
    for (const std::string& name : needs_[indices.front()]) {
      const bool by_all = std::all_of(indices.begin(), indices.end(), [&](std::size_t i) {
        const std::vector<std::string>& needed = needs_[i];
        return std::find(needed.begin(), needed.end(), name) != needed.end();
      });
      if (by_all && find(name) == nullptr) common.push_back(name);
    }
    return common;
  }

  void add_unwritten(const std::map<const Function*, Indices>& failing) {
    Cause cause{.kind = Cause::Kind::unwritten};
    for (const Function& function : functions_) {
      const auto found = failing.find(&function);
      if (found == failing.end() || !function.unwritten) continue;
      cause.functions.push_back(function.name);
      const bool first = cause.functions.size() == 1;
      for (const std::size_t i : found->second)
        (first && asked_function(i) == function.name ? cause.shown : cause.waiting).push_back(i);
    }
    if (!cause.functions.empty()) step_.causes.push_back(std::move(cause));
  }

  StepResult& step_;
  const std::vector<JudgedCase>& cases_;
  const StepReferences& references_;
  std::vector<std::vector<std::string>> needs_;  ///< by case
  std::vector<Function> functions_;              ///< in the order in which probes ask them
};

}  // namespace

void explain_step(StepResult& step, const std::vector<JudgedCase>& cases, const StepReferences& references) {
  CauseFinder(step, cases, references).find_causes();
}

}  // namespace atelier::judge
