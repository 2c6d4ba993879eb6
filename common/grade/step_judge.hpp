// One step, from somebody's sources to verdicts: build, ask, judge. Everything that gives points goes through here.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "judge/compare/judged_case.hpp"
#include "judge/compare/references.hpp"
#include "judge/compare/result.hpp"
#include "judge/compare/verdict.hpp"
#include "judge/run/build.hpp"
#include "judge/run/runner.hpp"

namespace atelier::grade {

/// Whose code: two folders that hold NN-name/ folders, of sources and of the libraries built from them.
struct Code {
  std::filesystem::path sources, libraries;
};

/// What a step is judged by. The mistakes name what went wrong; a step may have none yet.
struct Criteria {
  std::filesystem::path cases;            ///< tests/cases/NN-name/cases.json
  std::filesystem::path mistakes;         ///< tests/mistakes/NN-name/mistakes.json
  std::filesystem::path reference_cache;  ///< of decoded pictures; empty: none
};

class StepJudge {
 public:
  /// Reads the cases, those named in `only` or all. Throws Error for a broken file, one that lies in another step's
  /// folder or names a mistake that is not there, and for a case that is not there.
  explicit StepJudge(const Criteria& criteria, const std::vector<std::string>& only = {});

  const std::string& step() const { return file_.step; }
  const std::vector<judge::JudgedCase>& cases() const { return file_.cases; }
  const judge::StepReferences& references() const { return references_; }

  /// Reads all references now. Throws Error where one is missing or broken: then nobody can be judged.
  void require_references() const { references_.require(file_.cases); }

  /// Has the solution draw every picture now, in the place of the stored references: for a driver that draws edges
  /// otherwise than the one that they were made with. `solution` says how; it is to ask the same driver as `judge`
  /// will. The numbers of probes and the truths of budget cases do not depend on a driver, and stay. Throws Error
  /// naming the case that is not drawn.
  void use_live_references(const judge::RunSettings& solution);

  /// Asks the program for every case and judges each answer as it comes in. `settings` says which program and whose
  /// code; `keep` says which results carry pictures; `on_case` is called after each verdict. Throws Error only where
  /// the judge's own side is at fault.
  using OnCase = std::function<void()>;
  judge::StepResult judge(const judge::RunSettings& settings, judge::KeepEvidence keep = judge::KeepEvidence::failures,
                          const OnCase& on_case = {}) const;

  /// What everybody gets whose files do not build: the compiler's words, or which files are missing, and no points.
  judge::StepResult judge_unbuilt(const judge::Built& built) const;

  /// What somebody gets who handed in nothing for this step, or not all of it; `why` is a sentence.
  judge::StepResult judge_absent(const std::string& why = "Nothing was handed in for this step.") const;

 private:
  StepJudge(const Criteria& criteria, const std::vector<std::string>& only,
            const std::vector<judge::Mistake>& mistakes);
  judge::StepResult empty_result() const;
  judge::StepResult judge_all_alike(const judge::Answer& answer) const;

  judge::CaseFile file_;
  judge::StepReferences references_;
  bool live_ = false;
};

/// The score of a step is the sum of its cases', that of a submission the sum of its steps'.
void sum_up(judge::StepResult& step);
void sum_up(judge::SubmissionResult& submission);

/// Whether every case passed.
bool all_passed(const judge::StepResult& step);

}  // namespace atelier::grade
