// Which known mistakes agree with all answers of a step.
#pragma once

#include <string>
#include <vector>

#include "judge/compare/judged_case.hpp"
#include "judge/compare/references.hpp"
#include "judge/compare/result.hpp"

namespace atelier::judge {

class Agreement {
 public:
  /// All must live as long as this object. results[i] is the verdict on cases[i].
  Agreement(const std::vector<CaseResult>& results, const std::vector<JudgedCase>& cases,
            const StepReferences& references);

  /// The only mistake that this case's answer could be and that no other answer contradicts; empty if there is none, or
  /// more than one. `waits`: the case fails for a function that is known to be wrong, so that a probe must confirm the
  /// mistake.
  std::string name_of(std::size_t index, bool waits) const;

 private:
  enum class Witness { none, agrees, contradicts };
  /// What all cases say about a mistake: any of its forms may explain a probe (compare/sidecar.hpp). It must explain
  /// all failing probes that ask `function` first.
  Witness witness(const std::string& mistake, const std::string& function) const;
  Witness witness(const std::string& mistake, const std::string& function, std::size_t index) const;

  /// Whether the answer to a probe is that of the mistake's patch, and not only of another spelling.
  bool could_be_patch(const std::string& mistake, std::size_t index) const;

  const std::vector<CaseResult>& results_;
  const std::vector<JudgedCase>& cases_;
  const StepReferences& references_;
};

}  // namespace atelier::judge
