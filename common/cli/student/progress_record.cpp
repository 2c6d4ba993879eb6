#include "cli/student/progress_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/folder_lock.hpp"
#include "base/sha256.hpp"
#include "base/strict_json.hpp"
#include "judge/report/report_words.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using strict_json::Json;

constexpr double most_points = 1e6;

// --- Reading ---

std::string digest(const Json& value, const std::string& where) {
  const std::string text = strict_json::name(value, where, "");
  if (text.size() != 64 || text.find_first_not_of("0123456789abcdef") != text.npos)
    strict_json::refuse(value, where, "the 64 hexadecimal digits of a SHA-256 digest");
  return text;
}

const Json& object(const Json& value, const std::string& where) {
  if (!value.is_object()) strict_json::refuse(value, where, "an object {...}");
  return value;
}

CheckRecord check_from(const Json& value, const std::string& where) {
  strict_json::refuse_unknown(value, {"when", "score", "max_score", "files", "cases", "begin_with", "wrong_function"},
                              where);
  const auto member = [&](const char* name) -> const Json& { return strict_json::required(value, name, where); };
  CheckRecord check;
  check.when = strict_json::text(member("when"), where + ": when", 40);
  check.score = strict_json::number(member("score"), where + ": score", 0, most_points);
  check.max_score = strict_json::number(member("max_score"), where + ": max_score", 0, most_points);
  check.files = digest(member("files"), where + ": files");
  for (const auto& [name, passed] : object(member("cases"), where + ": cases").items())
    check.cases[name] = strict_json::boolean(passed, where + ": cases: " + name);
  if (const Json* begin_with = strict_json::optional(value, "begin_with"))
    check.begin_with = strict_json::name(*begin_with, where + ": begin_with");
  if (const Json* function = strict_json::optional(value, "wrong_function"))
    check.wrong_function = strict_json::text(*function, where + ": wrong_function", 100);
  return check;
}

StepProgress step_from(const Json& value, const std::string& where) {
  strict_json::refuse_unknown(value, {"best", "check", "hints"}, where);
  StepProgress step;
  if (const Json* best = strict_json::optional(value, "best"))
    step.best = strict_json::number(*best, where + ": best", 0, most_points);
  if (const Json* check = strict_json::optional(value, "check")) step.check = check_from(*check, where + ": check");
  if (const Json* hints = strict_json::optional(value, "hints"))
    for (const auto& [name, level] : object(*hints, where + ": hints").items())
      step.hints[name] = strict_json::integer(level, where + ": hints: " + name, 1, most_hints);
  return step;
}

ProgressRecord record_from(const std::string& text, const std::string& where) {
  const Json document = strict_json::parse(text, where);
  strict_json::refuse_unknown(document, {"schema", "steps"}, where);
  strict_json::integer(strict_json::required(document, "schema", where), where + ": schema", 1, 1);
  ProgressRecord record;
  for (const auto& [name, step] : object(strict_json::required(document, "steps", where), where + ": steps").items())
    record[name] = step_from(step, where + ": " + name);
  return record;
}

// --- Writing ---

using OrderedJson = nlohmann::ordered_json;

OrderedJson to_json(const StepProgress& step) {
  OrderedJson json = {{"best", step.best}};
  if (step.check)
    json["check"] = {{"when", step.check->when},
                     {"score", step.check->score},
                     {"max_score", step.check->max_score},
                     {"files", step.check->files},
                     {"cases", step.check->cases}};
  if (step.check && !step.check->begin_with.empty()) json["check"]["begin_with"] = step.check->begin_with;
  if (step.check && !step.check->wrong_function.empty()) json["check"]["wrong_function"] = step.check->wrong_function;
  if (!step.hints.empty()) json["hints"] = step.hints;
  return json;
}

std::string now_in_utc() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", gmtime_r(&now, &parts));
  return text;
}

}  // namespace

int CheckRecord::passed() const {
  return int(std::count_if(cases.begin(), cases.end(), [](const auto& c) { return c.second; }));
}

ProgressRecord read_progress(const fs::path& file) {
  if (!fs::exists(file)) return {};
  const std::string text = read_file(file, 4 << 20);
  try {
    return record_from(text, file.string());
  } catch (const Error& error) {
    throw Error(fmt::format("{}; fix the file, or move it away to start a new one", error.what()));
  }
}

void write_progress(const fs::path& file, const ProgressRecord& record) {
  OrderedJson steps = OrderedJson::object();
  for (const auto& [name, step] : record) steps[name] = to_json(step);
  write_file(file, OrderedJson{{"schema", 1}, {"steps", steps}}.dump(2) + "\n");
}

void change_progress(const fs::path& file, const std::function<void(ProgressRecord&)>& change) {
  const FolderLock lock(file.parent_path());
  ProgressRecord record = read_progress(file);
  change(record);
  write_progress(file, record);
}

void record_check(ProgressRecord& record, const judge::StepResult& result, const std::string& files) {
  CheckRecord check{.when = now_in_utc(), .score = result.score, .max_score = result.max_score, .files = files};
  for (const judge::CaseResult& c : result.cases) check.cases[c.name] = c.status == judge::Status::passed;
  if (!result.causes.empty()) {
    const judge::Cause& cause = result.causes.front();
    check.begin_with = judge::shown_case(result, cause).name;
    if (cause.kind == judge::Cause::Kind::function) check.wrong_function = cause.functions.front();
  }
  StepProgress& step = record[result.step];
  step.best = std::max(step.best, check.score);
  step.check = std::move(check);
}

int hint_level(const ProgressRecord& record, const std::string& step, const std::string& case_name) {
  const auto found = record.find(step);
  if (found == record.end()) return 0;
  const auto level = found->second.hints.find(case_name);
  return level == found->second.hints.end() ? 0 : level->second;
}

void raise_hint_level(ProgressRecord& record, const std::string& step, const std::string& case_name, int level) {
  int& shown = record[step].hints[case_name];
  shown = std::max(shown, level);
}

std::string digest_of_files(const fs::path& folder, const std::vector<std::string>& files) {
  std::string lines;
  for (const std::string& file : files) {
    const bool there = fs::is_regular_file(folder / file);
    lines += (there ? sha256(read_file(folder / file)) : "missing") + "  " + file + "\n";
  }
  return sha256(lines);
}

bool has_passed(const StepProgress& progress, const std::vector<std::string>& cases, const std::string& files) {
  if (!progress.check || progress.check->files != files) return false;
  return std::all_of(cases.begin(), cases.end(), [&](const std::string& name) {
    const auto found = progress.check->cases.find(name);
    return found != progress.check->cases.end() && found->second;
  });
}

}  // namespace atelier
