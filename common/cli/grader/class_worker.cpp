#include "cli/grader/class_worker.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <system_error>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/folder_lock.hpp"
#include "base/printable.hpp"
#include "base/sha256.hpp"
#include "base/stopwatch.hpp"
#include "cli/grader/result_files.hpp"
#include "cli/grader/submission_grader.hpp"
#include "cli/stop.hpp"
#include "grade/course/feedback.hpp"
#include "grade/course/grading_rules.hpp"
#include "grade/intake/submission.hpp"
#include "grade/results/mistake_pictures.hpp"
#include "grade/results/record.hpp"
#include "judge/report/kept_steps.hpp"
#include "sandbox/control_group.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using grade::HandedIn;
using grade::StepRecord;
using grade::Submission;
using grade::SubmissionRecord;

/// A record of its submission, and what its reports are made from.
struct Graded {
  SubmissionRecord record;
  judge::SubmissionResult result;
};

StepRecord::State state_of(const Submission& submission, const judge::StepResult& step) {
  using State = StepRecord::State;
  if (submission.untouched.contains(step.step)) return State::untouched;
  if (!submission.present.contains(step.step) && !submission.skipped.contains(step.step)) return State::not_handed_in;
  if (submission.skipped.contains(step.step) || submission.unusable.contains(step.step)) return State::not_built;
  const auto is_unbuilt = [](const judge::CaseResult& c) { return c.status == judge::Status::build_failed; };
  return !step.cases.empty() && std::ranges::all_of(step.cases, is_unbuilt) ? State::not_built : State::judged;
}

/// What a person must look at, since the points alone would be a harsh answer.
std::vector<std::string> doubts_about(const Submission& submission, const judge::StepResult& step,
                                      StepRecord::State state) {
  std::vector<std::string> doubts;
  if (state == StepRecord::State::not_built && !submission.unusable.contains(step.step))  // said with the submission
    doubts.push_back(fmt::format("{} was handed in and could not be built: {}", step.step,
                                 step.cases.empty() ? "no reason given" : step.cases.front().reason));
  const auto has = [&](judge::Status status) {
    return std::ranges::any_of(step.cases, [&](const judge::CaseResult& c) { return c.status == status; });
  };
  const auto unanswered = std::ranges::count(step.cases, judge::Status::missing, &judge::CaseResult::status);
  if (state == StepRecord::State::judged && 2 * std::size_t(unanswered) > step.cases.size())
    doubts.push_back(
        fmt::format("{} gives no answer to {} of {} cases: {}", step.step, unanswered, step.cases.size(),
                    std::ranges::find(step.cases, judge::Status::missing, &judge::CaseResult::status)->reason));
  if (has(judge::Status::timeout)) doubts.push_back(step.step + " ran out of time");
  return doubts;
}

/// The file that says what a process works on; it stays if the process is killed.
class AtWork {
 public:
  AtWork(fs::path file, const std::string& id) : file_(std::move(file)) { write_file(file_, id); }
  ~AtWork() {
    std::error_code ignored;
    fs::remove(file_, ignored);
  }
  AtWork(const AtWork&) = delete;
  AtWork& operator=(const AtWork&) = delete;

 private:
  fs::path file_;
};

class ClassWorker {
 public:
  explicit ClassWorker(const GradeWorkerOptions& options)
      : options_(options),
        places_{fs::absolute(options.out)},
        plan_written_(fs::last_write_time(places_.plan())),
        plan_(read_plan(places_)),
        folders_(project_folders()),
        course_(read_course(folders_.step_flags())),
        rules_(read_rules(plan_.course_file, course_)),
        grader_(folders_, course_, resolve_steps(course_, plan_.steps), settings_of(plan_, rules_)) {}

  void run() {
    const std::vector<HandedIn>& all = plan_.folder.submissions;
    for (std::size_t i = std::size_t(options_.index); i < all.size(); i += std::size_t(options_.of)) take(all[i]);
    for (const HandedIn& handed_in : all) take(handed_in);
  }

 private:
  static GraderSettings settings_of(const ClassPlan& plan, const grade::CourseFile& rules) {
    GraderSettings settings{.context = plan.context,
                            .workers = 1,
                            .shuffle = plan.shuffle,
                            .tier = sandbox::tier_named(plan.sandbox).value_or(sandbox::Tier::none),
                            .more_cases = plan.cases,
                            .case_limit = {}};
    if (rules.seconds) settings.case_limit = std::chrono::milliseconds(std::int64_t(*rules.seconds * 1000));
    return settings;
  }

  bool is_done(const HandedIn& handed_in) const { return is_graded(places_, handed_in.student.id, plan_written_); }

  void take(const HandedIn& handed_in) {
    if (stop_.requested()) throw judge::Interrupted();
    const fs::path folder = places_.student(handed_in.student.id);
    if (is_done(handed_in)) return;
    fs::create_directories(folder);
    const std::optional<FolderLock> lock = FolderLock::try_lock(folder);
    if (!lock || is_done(handed_in)) return;
    const AtWork at_work(places_.at_work(options_.index), handed_in.student.id);
    remove_unfinished_files(folder);
    try {
      grade(handed_in);
    } catch (const judge::Interrupted&) {
      throw;
    } catch (const std::exception& error) {
      require_own_plan();
      record_failure(places_, plan_, handed_in, fmt::format("It was not graded: {}", error.what()));
    }
  }

  /// A killed `grade` may leave processes on other machines. Records of theirs would pass for those of the next one.
  void require_own_plan() const {
    if (fs::last_write_time(places_.plan()) != plan_written_) throw judge::Interrupted();
  }

  void grade(const HandedIn& handed_in) {
    const Stopwatch all;
    const TemporaryFolder copies("atelier-submission");
    const fs::path skeletons = is_release() ? folders_.skeletons() : folders_.root / "steps";
    const bool best = rules_.attempts == grade::Attempts::best && handed_in.sources.size() > 1;
    std::vector<std::vector<fs::path>> versions = {handed_in.sources};
    if (best) {
      versions.clear();
      for (const fs::path& source : handed_in.sources) versions.push_back({source});
    }
    std::vector<Submission> submissions;
    std::string key = key_of_plan(handed_in);
    for (const std::vector<fs::path>& sources : versions) {
      // Directly in the folder that sandboxes are let through.
      const fs::path copy = copies.path() / fmt::format("files-{}", submissions.size());
      submissions.push_back(grade::take_submission(grader_.flags(), sources, copy, skeletons));
      key += hash_of(submissions.back());
    }
    key = sha256(key);
    if (reuse(handed_in, key)) return;
    const SubmissionRecord earlier = earlier_record(handed_in.student.id).value_or(SubmissionRecord{});

    std::vector<Graded> graded;
    std::vector<SubmissionRecord> records;
    for (const Submission& submission : submissions) {
      graded.push_back(grade_version(handed_in, submission));
      records.push_back(graded.back().record);
    }
    Graded& counts = graded[grade::counting_version(records, rules_)];
    counts.record.key = key;
    write(counts, earlier, all);
  }

  /// What decides on the verdict besides the files: cases, solutions, settings, and who handed in when.
  std::string key_of_plan(const HandedIn& handed_in) const {
    std::string key = fmt::format("{}\n{}\n{}\n{}\n{}\n", plan_.context, plan_.sandbox, plan_.seed.value_or(0),
                                  plan_.shuffle.value_or(0), handed_in.student.id);
    key += fmt::format("{} {} {}\n", handed_in.handed_in.value_or(0), handed_in.late, handed_in.source);
    key += to_string(rules_.feedback) + to_string(rules_.attempts) + fmt::format(" {}\n", rules_.seconds.value_or(0));
    for (const auto& [step, hash] : plan_.criteria) key += step + ' ' + hash + '\n';
    for (const std::vector<std::string>* list : {&handed_in.notes, &handed_in.needs_human})
      for (const std::string& sentence : *list) key += sentence + '\n';
    return key;
  }

  static std::string hash_of(const Submission& submission) {
    std::string text = fmt::format("{}", grade::seed_of(submission));
    for (const auto& [step, files] : submission.unusable) text += step + judge::in_words(files) + '\n';
    for (const auto& [step, why] : submission.skipped) text += step + why + '\n';
    for (const std::string& note : submission.notes) text += note + '\n';
    for (const std::string& why : submission.needs_human) text += why + '\n';
    return sha256(text);
  }

  /// Keeps an earlier record of the same files and criteria.
  bool reuse(const HandedIn& handed_in, const std::string& key) const {
    const std::optional<SubmissionRecord> earlier = earlier_record(handed_in.student.id);
    if (!earlier || earlier->key != key) return false;
    // By the clock that the plan's time is of: on a network's file system, that of the server.
    require_own_plan();
    return ::utimensat(AT_FDCWD, places_.record(handed_in.student.id).c_str(), nullptr, 0) == 0;
  }

  /// Nothing also where it is damaged, or of another version.
  std::optional<SubmissionRecord> earlier_record(const std::string& id) const {
    try {
      return grade::read_record(places_.record(id));
    } catch (const Error&) {
      return std::nullopt;
    }
  }

  Graded grade_version(const HandedIn& handed_in, const Submission& submission) {
    Graded graded;
    SubmissionRecord& record = graded.record;
    record = {.student = handed_in.student,
              .source = handed_in.source,
              .handed_in = handed_in.handed_in,
              .late = handed_in.late,
              .needs_human = handed_in.needs_human,
              .notes = handed_in.notes,
              .sandbox = plan_.sandbox};
    const auto append = [](std::vector<std::string>& to, const std::vector<std::string>& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    append(record.needs_human, submission.needs_human);
    append(record.notes, submission.notes);
    record.seed = seed_for(handed_in, submission);
    graded.result = grader_.grade(submission, record.seed, {.interrupted = [&] { return stop_.requested(); }});
    graded.result.may_grow = true;
    // The student reads too what a person must decide.
    append(graded.result.notes, handed_in.notes);
    append(graded.result.notes, submission.needs_human);
    graded.result.submission = handed_in.student.name.empty() ? handed_in.student.id : handed_in.student.name;
    for (const judge::StepResult& step : graded.result.steps) {
      const StepRecord::State state = state_of(submission, step);
      record.steps.push_back(grade::record_of(step, state));
      append(record.needs_human, doubts_about(submission, step, state));
      for (const auto& [kind, seconds] : step.seconds) record.seconds[kind] += seconds;
    }
    return graded;
  }

  /// With a seed for the class, its students still have numbers of their own.
  std::uint64_t seed_for(const HandedIn& handed_in, const Submission& submission) const {
    if (!plan_.seed) return grade::seed_of(submission);
    const std::string text = fmt::format("{} {}", *plan_.seed, handed_in.student.id);
    return std::stoull(sha256(text).substr(0, 16), nullptr, 16) & grade::max_seed;
  }

  /// Where only some steps are graded, the others stay as they are in the folder.
  static void keep_other_steps(Graded& graded, const SubmissionRecord& earlier, const fs::path& folder) {
    for (judge::StepResult& step : judge::kept_steps(folder, graded.result.steps))
      graded.result.steps.push_back(std::move(step));
    std::ranges::stable_sort(graded.result.steps, {}, &judge::StepResult::step);
    grade::sum_up(graded.result);
    const auto is_graded = [&](const StepRecord& step) {
      return std::ranges::any_of(graded.record.steps, [&](const StepRecord& other) { return other.step == step.step; });
    };
    std::vector<StepRecord> kept = earlier.steps;
    std::erase_if(kept, is_graded);
    for (const StepRecord& step : kept)
      for (const std::string& doubt : earlier.needs_human)
        if (doubt.starts_with(step.step)) graded.record.needs_human.push_back(doubt);
    graded.record.steps.insert(graded.record.steps.end(), kept.begin(), kept.end());
    std::ranges::stable_sort(graded.record.steps, {}, &StepRecord::step);
  }

  void write(Graded& graded, const SubmissionRecord& earlier, const Stopwatch& all) {
    const fs::path folder = places_.student(graded.record.student.id);
    const Stopwatch reporting;
    judge::SubmissionResult& result = graded.result;
    grade::write_mistake_pictures(grade::pictures_folder(places_.out, graded.record), result);
    grade::limit_feedback(result, rules_.feedback);
    keep_other_steps(graded, earlier, folder);
    // If this process is killed here, the old record must not stand beside new reports.
    require_own_plan();
    fs::remove(places_.record(graded.record.student.id));
    write_result_files(result, folder);
    double known = graded.record.seconds["report"] = reporting.seconds();
    for (const auto& [kind, seconds] : graded.record.seconds)
      if (kind != "report") known += seconds;
    graded.record.seconds["other"] = std::max(0.0, all.seconds() - known);
    require_own_plan();
    write_file(places_.record(graded.record.student.id), to_json_text(graded.record));
  }

  const GradeWorkerOptions& options_;
  const StopOnSignal stop_;
  ClassPlaces places_;
  fs::file_time_type plan_written_;
  ClassPlan plan_;
  ProjectFolders folders_;
  std::vector<CourseStep> course_;
  grade::CourseFile rules_;
  SubmissionGrader grader_;
};

}  // namespace

bool is_graded(const ClassPlaces& places, const std::string& id, fs::file_time_type plan_written) {
  std::error_code missing;
  const fs::file_time_type written = fs::last_write_time(places.record(id), missing);
  return !missing && written >= plan_written;
}

void record_failure(const ClassPlaces& places, const ClassPlan& plan, const HandedIn& handed_in,
                    const std::string& why) {
  SubmissionRecord record{.student = handed_in.student,
                          .source = handed_in.source,
                          .handed_in = handed_in.handed_in,
                          .late = handed_in.late,
                          .steps = {},
                          .needs_human = handed_in.needs_human,
                          .notes = handed_in.notes,
                          .sandbox = plan.sandbox};
  record.needs_human.push_back(shorten(printable(why), 1000));
  remove_result_files(places.student(handed_in.student.id));
  write_file(places.record(handed_in.student.id), to_json_text(record));
}

int run_grade_worker(const GradeWorkerOptions& options) {
  ClassWorker(options).run();
  return exit_ok;
}

}  // namespace atelier
