#include "grade/step_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/error.hpp"
#include "base/near_names.hpp"
#include "base/stopwatch.hpp"
#include "judge/explain/causes.hpp"
#include "judge/run/ask.hpp"

namespace atelier::grade {
namespace {

namespace fs = std::filesystem;
using judge::Answer;
using judge::CaseFile;
using judge::CaseResult;
using judge::JudgedCase;
using judge::StepResult;

/// Checks that the file's step is its folder's name and that all mistakes in `rejects` exist.
void check_names(const CaseFile& file, const fs::path& path, const std::vector<judge::Mistake>& mistakes) {
  if (const std::string folder = path.parent_path().filename().string(); file.step != folder)
    throw Error(
        fmt::format("{}: step: '{}' is not the name of the file's folder, '{}'", path.string(), file.step, folder));
  std::vector<std::string> names;
  for (const judge::Mistake& mistake : mistakes) names.push_back(mistake.name);
  for (const JudgedCase& c : file.cases)
    for (const std::string& name : c.rejects)
      if (std::find(names.begin(), names.end(), name) == names.end())
        throw Error(fmt::format("{}: case '{}': rejects: there is no mistake '{}'{}", path.string(), c.ask.name, name,
                                suggestion(name, names)));
}

CaseFile read_checked(const Criteria& criteria, const std::vector<judge::Mistake>& mistakes) {
  CaseFile file = judge::read_case_file(criteria.cases);
  if (fs::exists(criteria.mistakes)) check_names(file, criteria.cases, mistakes);
  return file;
}

/// Leaves the cases named in `only`, or all, and returns the other probes.
std::vector<JudgedCase> select(CaseFile& file, const std::vector<std::string>& only) {
  if (only.empty()) return {};
  std::vector<std::string> names;
  for (const JudgedCase& c : file.cases) names.push_back(c.ask.name);
  for (const std::string& name : only)
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw Error(fmt::format("{}: there is no case '{}'{}", file.path.string(), name, suggestion(name, names)));
  const auto others = std::stable_partition(file.cases.begin(), file.cases.end(), [&](const JudgedCase& c) {
    return std::find(only.begin(), only.end(), c.ask.name) != only.end();
  });
  std::vector<JudgedCase> probes;
  std::copy_if(others, file.cases.end(), std::back_inserter(probes),
               [](const JudgedCase& c) { return c.profile == judge::Profile::values; });
  file.cases.erase(others, file.cases.end());
  return probes;
}

/// A case as it is asked: a stored one, or one with drawn numbers.
struct Question {
  const JudgedCase* judged;
  std::size_t place;  ///< of the stored case
  bool varies;
};

/// Each case with drawn numbers follows its stored one: the scene that both show is made once.
std::vector<Question> questions_of(const std::vector<JudgedCase>& stored, const VariedCases* varied) {
  std::vector<Question> questions;
  std::size_t next = 0;
  for (std::size_t i = 0; i < stored.size(); ++i) {
    questions.push_back({&stored[i], i, false});
    if (varied && next < varied->cases.size() && varied->cases[next].of == i)
      questions.push_back({&varied->cases[next++].judged, i, true});
  }
  return questions;
}

/// Removes the results of cases from `count` on.
void keep_first(StepResult& result, std::size_t count) {
  result.cases.resize(count);
  for (judge::Cause& cause : result.causes) {
    std::erase_if(cause.shown, [&](std::size_t i) { return i >= count; });
    std::erase_if(cause.waiting, [&](std::size_t i) { return i >= count; });
  }
  std::erase_if(result.causes, [](const judge::Cause& cause) { return cause.shown.empty() && cause.waiting.empty(); });
}

std::vector<judge::Mistake> mistakes_of(const fs::path& path) {
  return fs::exists(path) ? judge::read_mistakes(path, judge::Patches::optional) : std::vector<judge::Mistake>{};
}

/// The first line with an error in a compiler's log ("blinn_phong.cpp:12:3: error: ..."), or else its first line.
std::string first_error(const std::string& log) {
  std::string first;
  for (std::size_t begin = 0; begin < log.size();) {
    const std::size_t end = std::min(log.find('\n', begin), log.size());
    const std::string line = log.substr(begin, end - begin);
    if (line.find("error:") != std::string::npos) return line;
    if (first.empty()) first = line;
    begin = end + 1;
  }
  return first;
}

}  // namespace

StepJudge::StepJudge(const Criteria& criteria, const std::vector<std::string>& only)
    : StepJudge(criteria, only, mistakes_of(criteria.mistakes)) {}

StepJudge::StepJudge(const Criteria& criteria, const std::vector<std::string>& only,
                     const std::vector<judge::Mistake>& mistakes)
    : title_(criteria.title),
      file_(read_checked(criteria, mistakes)),
      witnesses_(select(file_, only)),
      references_(file_.step, mistakes, judge::references_folder(criteria.cases), criteria.reference_cache) {}

StepResult StepJudge::empty_result() const {
  StepResult result;
  result.step = file_.step;
  result.title = title_;
  if (live_) result.references = "live";
  result.cases.resize(file_.cases.size());
  return result;
}

void StepJudge::use_live_references(const judge::RunSettings& solution) {
  std::vector<const JudgedCase*> pictures;
  std::vector<Case> asks;
  for (const JudgedCase& c : file_.cases)
    if (c.ask.probe.empty() && !c.choice) pictures.push_back(&c), asks.push_back(c.ask);
  const std::vector<Answer> answers = judge::run_cases(solution, asks);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (!answers[i].pixels)
      throw Error(fmt::format("live references: the solution of {} cannot draw case '{}' here: {}", file_.step,
                              asks[i].name, answers[i].error));
    references_.set_pictures(*pictures[i], {*answers[i].pixels});
  }
  live_ = true;
}

void StepJudge::add_cases(const fs::path& path, const judge::RunSettings& solution) {
  CaseFile more = judge::read_case_file(path);
  const auto refuse = [&](const std::string& what) { throw Error(fmt::format("{}: {}", path.string(), what)); };
  if (more.step != file_.step) refuse(fmt::format("step: '{}' is not '{}'", more.step, file_.step));
  std::vector<Case> asks;
  for (JudgedCase& c : more.cases) {
    const auto has_name = [&](const JudgedCase& other) { return other.ask.name == c.ask.name; };
    if (std::ranges::any_of(file_.cases, has_name)) refuse(fmt::format("case '{}': the step has one too", c.ask.name));
    if (c.choice) refuse(fmt::format("case '{}': a case with a choice cannot be added", c.ask.name));
    c.hidden = true;
    c.expected.clear(), c.expected_file.clear(), c.references.clear();  // the solution answers
    asks.push_back(c.ask);
  }
  std::vector<Answer> answers = judge::run_cases(solution, asks);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const std::string error = answers[i].error;
    std::optional<judge::CaseReferences> references = as_references(more.cases[i], std::move(answers[i]));
    if (!references) refuse(fmt::format("case '{}': the solution does not answer it: {}", asks[i].name, error));
    references_.add(asks[i].name, std::move(*references));
    file_.cases.push_back(std::move(more.cases[i]));
  }
}

VariedCases StepJudge::vary(std::uint64_t seed, const judge::RunSettings& solution) const {
  return vary_cases(file_.cases, references_, seed, solution);
}

StepResult StepJudge::judge(const judge::RunSettings& settings, judge::KeepEvidence keep, const OnCase& on_case,
                            const VariedCases* varied) const {
  std::vector<JudgedCase> stored = file_.cases;
  stored.insert(stored.end(), witnesses_.begin(), witnesses_.end());
  const std::vector<Question> questions = questions_of(stored, varied);
  std::vector<JudgedCase> asked;
  for (const Question& question : questions) asked.push_back(*question.judged);

  const Stopwatch all;
  double rendering = 0, comparing = 0;
  judge::RunSettings patient = settings;
  if (varied) patient.max_time_outs *= 2;  // a case that hangs may hang with both numbers
  StepResult result = empty_result();
  result.cases.resize(stored.size());
  std::vector<CaseResult> with_other_numbers(stored.size());
  // Judges each answer while the programs draw the next.
  judge::ask_cases(patient, file_.step, asked, [&](std::size_t index, const Answer& answer) {
    const auto& [judged, place, varies] = questions[index];
    const Stopwatch watch;
    (varies ? with_other_numbers : result.cases)[place] =
        judge::judge_case(*judged, answer, varies ? varied->references : references_, keep);
    rendering += answer.seconds;
    comparing += watch.seconds();
    if (on_case && !varies && place < file_.cases.size()) on_case();
  });
  const Stopwatch explaining;
  if (varied)
    for (const VariedCase& c : varied->cases)
      result.cases[c.of] = both(std::move(result.cases[c.of]), std::move(with_other_numbers[c.of]), c.numbers);
  judge::explain_step(result, stored, references_);
  keep_first(result, file_.cases.size());
  sum_up(result);
  comparing += explaining.seconds();
  rendering /= settings.workers;  // they draw at the same time
  result.seconds = {
      {"render", rendering}, {"compare", comparing}, {"start", std::max(0.0, all.seconds() - rendering - comparing)}};
  return result;
}

StepResult StepJudge::judge_all_alike(const Answer& answer) const {
  StepResult result = empty_result();
  for (std::size_t i = 0; i < file_.cases.size(); ++i)
    result.cases[i] = judge::judge_case(file_.cases[i], answer, references_);
  judge::explain_step(result, file_.cases, references_);
  sum_up(result);
  return result;
}

StepResult StepJudge::judge_absent(const std::string& why, const std::string& hint) const {
  Answer answer;
  answer.error = why;
  StepResult result = judge_all_alike(answer);
  for (CaseResult& c : result.cases)
    c.hint =
        !hint.empty()
            ? hint
            : fmt::format("All files of the step must be in {}/, each a regular file under its own name.", file_.step);
  return result;
}

StepResult StepJudge::judge_unbuilt(const judge::Built& built) const {
  if (!built.unusable.empty()) return judge_absent(first_error(built.log));
  Answer answer;
  answer.ended = Answer::Ended::build_failed;
  answer.error = first_error(built.log);
  StepResult result = judge_all_alike(answer);
  result.build_log = built.log;
  return result;
}

void sum_up(StepResult& step) {
  step.score = step.max_score = 0;
  for (const CaseResult& c : step.cases) {
    step.score += c.score;
    step.max_score += c.max_score;
  }
}

void sum_up(judge::SubmissionResult& submission) {
  submission.score = submission.max_score = 0;
  for (const StepResult& step : submission.steps) {
    submission.score += step.score;
    submission.max_score += step.max_score;
  }
}

bool all_passed(const StepResult& step) {
  return std::all_of(step.cases.begin(), step.cases.end(),
                     [](const CaseResult& c) { return c.status == judge::Status::passed; });
}

}  // namespace atelier::grade
