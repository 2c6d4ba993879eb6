#include "cli/student/own_check.hpp"

#include <fmt/format.h>

#include <future>

#include "base/error.hpp"
#include "cli/criteria.hpp"
#include "cli/student/own_files.hpp"
#include "cli/student/progress_record.hpp"
#include "cli/student/unfinished.hpp"
#include "judge/report/preview.hpp"
#include "judge/report/report_html.hpp"
#include "judge/report/report_json.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

/// The picture for preview.png: the first one that fails, or the first one.
const judge::Evidence* picture_to_show(const judge::StepResult& result) {
  const judge::Evidence* first = nullptr;
  for (const judge::CaseResult& c : result.cases) {
    if (!c.evidence) continue;
    if (c.status != judge::Status::passed) return &*c.evidence;
    if (first == nullptr) first = &*c.evidence;
  }
  return first;
}

}  // namespace

OwnCheck::OwnCheck(const ProjectFolders& folders, std::vector<CourseStep> course, CourseStep step,
                   OwnCheckOptions options)
    : folders_(folders),
      course_(std::move(course)),
      step_(std::move(step)),
      options_(std::move(options)),
      judge_(criteria_of(folders, step_), options_.cases) {
  if (options_.live && !is_there(folders_, step_.name, Owner::solution))
    throw Error(fmt::format(
        "--references live: the solution draws them, and this copy of the course has none of {} that runs here",
        step_.name));
  read_progress(folders_.progress());  // report an invalid record before the work
}

judge::StepResult OwnCheck::judge(const std::function<bool()>& interrupted) {
  judged_files_ = digest_of_files(folders_.steps() / step_.name, step_.files);
  std::future<void> references = std::async(std::launch::async, [&] { judge_.require_references(); });
  const OwnFiles own =
      prepare_own_files(folders_, course_, step_, own_code(folders_, options_.sources), options_.earlier);
  references.get();
  if (interrupted && interrupted()) throw judge::Interrupted();  // ignore the result of a stopped compiler

  judge::RunSettings settings = run_settings(folders_, step_, own.path, options_.context);
  settings.interrupted = interrupted;
  if (options_.live && !live_drawn_) {  // once: the solution does not change
    judge_.use_live_references(run_settings(folders_, step_, settings.solution.value(), options_.context));
    live_drawn_ = true;
  }
  judge::StepResult result =
      own.built.ok ? judge_.judge(settings, judge::KeepEvidence::always) : judge_.judge_unbuilt(own.built);
  if (own.built.unusable.empty()) result.build_log = own.built.log;
  result.implementations = in_words(own.earlier, step_.name, "yours");
  if (grade::all_passed(result)) return result;  // whatever the earlier steps are like
  const auto unfinished = unfinished_steps(folders_, course_, own.earlier);
  for (const auto& [name, state] : unfinished) result.implementations[name] += ", " + state;
  result.caveat = about_unfinished(folders_, step_, unfinished);
  return result;
}

void OwnCheck::record(const judge::StepResult& result) const {
  if (!counts_as_progress()) return;
  if (digest_of_files(folders_.steps() / step_.name, step_.files) != judged_files_) return;
  change_progress(folders_.progress(), [&](ProgressRecord& record) { record_check(record, result, judged_files_); });
}

fs::path own_report_folder(const ProjectFolders& folders, const std::string& step) {
  return folders.out() / "check" / step;
}

void write_own_report(judge::SubmissionResult& result, const fs::path& folder) {
  if (const judge::Evidence* evidence = picture_to_show(result.steps.front()))
    judge::write_preview(folder / "preview.png", *evidence);
  for (judge::CaseResult& c : result.steps.front().cases)
    if (c.status != judge::Status::passed) judge::draw_flip(c);
  judge::write_results_json(folder / "results.json", result);
  judge::write_html_report(folder / "report.html", result);
}

}  // namespace atelier
