// Judges one step: runs its program and compares the answers. All points come from here.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "grade/varied_cases.hpp"
#include "judge/compare/judged_case.hpp"
#include "judge/compare/references.hpp"
#include "judge/compare/result.hpp"
#include "judge/compare/verdict.hpp"
#include "judge/run/build.hpp"
#include "judge/run/runner.hpp"

namespace atelier::grade {

/// One implementation of the steps: a folder of sources and a folder of the libraries built from them. Both hold
/// NN-name/ folders.
struct Code {
  std::filesystem::path sources, libraries;
};

/// The files that a step is judged with.
struct Criteria {
  std::string title;                      ///< of the step, for reports
  std::filesystem::path cases;            ///< tests/cases/NN-name/cases.json
  std::filesystem::path mistakes;         ///< tests/mistakes/NN-name/mistakes.json; need not exist
  std::filesystem::path reference_cache;  ///< folder of decoded pictures; empty: no cache
};

class StepJudge {
 public:
  /// Reads the cases named in `only`, or all. Of a part, the step's other probes are asked too, for a fair explanation
  /// (judge/explain/causes.hpp). Throws Error for an invalid file, a file in another step's folder, an
  /// unknown mistake or an unknown case.
  explicit StepJudge(const Criteria& criteria, const std::vector<std::string>& only = {});

  const std::string& step() const { return file_.step; }
  const std::vector<judge::JudgedCase>& cases() const { return file_.cases; }
  const judge::StepReferences& references() const { return references_; }

  /// Reads all references now. Throws Error if one is missing or damaged, because then nothing can be judged.
  void require_references() const { references_.require(file_.cases); }

  /// Has the solution draw every picture now and uses these pictures instead of the stored references, for drivers that
  /// draw edges differently. `solution` must use the same driver as `judge` will. The numbers of probes and the truths
  /// of budget cases do not depend on the driver and are kept. Throws Error naming the case that is not drawn.
  void use_live_references(const judge::RunSettings& solution);

  /// Adds a grader's own cases, which no student has seen: a file like `cases` of the same step. The solution answers
  /// them now, so they need no references; it must use the same driver as `judge` will. Throws Error naming the file
  /// and the case for an invalid file, a name that a case of the step has, a budget case, and what the solution does
  /// not answer.
  void add_cases(const std::filesystem::path& file, const judge::RunSettings& solution);

  /// The cases with numbers drawn for one submission, answered by the solution; see vary_cases.
  VariedCases vary(std::uint64_t seed, const judge::RunSettings& solution) const;

  /// Asks the program for every case and judges each answer when it arrives. `settings` says which program and which
  /// code to run; `keep` says which results keep their pictures; `on_case` is called after the verdict on each stored
  /// case. A case that is among `varied` passes only if it passes there too. Throws Error only for problems that are
  /// not the student's.
  using OnCase = std::function<void()>;
  judge::StepResult judge(const judge::RunSettings& settings, judge::KeepEvidence keep = judge::KeepEvidence::failures,
                          const OnCase& on_case = {}, const VariedCases* varied = nullptr) const;

  /// The result if the files do not build: no points, and the compiler's messages or the unusable files.
  judge::StepResult judge_unbuilt(const judge::Built& built) const;

  /// The result if nothing, or not everything, was handed in for this step; `why` is a sentence, and so is
  /// `hint`; empty: where the files must be.
  judge::StepResult judge_absent(const std::string& why = "Nothing was handed in for this step.",
                                 const std::string& hint = "") const;

 private:
  StepJudge(const Criteria& criteria, const std::vector<std::string>& only,
            const std::vector<judge::Mistake>& mistakes);
  judge::StepResult empty_result() const;
  judge::StepResult judge_all_alike(const judge::Answer& answer) const;

  std::string title_;
  judge::CaseFile file_;
  std::vector<judge::JudgedCase> witnesses_;  ///< probes that are asked but not reported: they explain pictures
  judge::StepReferences references_;
  bool live_ = false;
};

/// The score of a step is the sum over its cases; that of a submission is the sum over its steps.
void sum_up(judge::StepResult& step);
void sum_up(judge::SubmissionResult& submission);

bool all_passed(const judge::StepResult& step);

}  // namespace atelier::grade
