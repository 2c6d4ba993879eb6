#include "hostile_submissions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/printable.hpp"
#include "base/strict_json.hpp"
#include "command.hpp"
#include "hostile_canary.hpp"

namespace atelier::test {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

fs::path hostile_folder() {
  return folders().root / "tests" / "hostile";
}

HostileSubmission::Builds builds_of(const std::string& word, const std::string& where) {
  if (word == "yes") return HostileSubmission::Builds::yes;
  if (word == "no") return HostileSubmission::Builds::no;
  if (word == "either") return HostileSubmission::Builds::either;
  throw Error(fmt::format("{}: builds: '{}' must be yes, no or either", where, word));
}

HostileSubmission submission_of(const json& object) {
  const std::string where = "hostile.json: " + object.at("name").get<std::string>();
  strict_json::refuse_unknown(object,
                              {"name", "step", "threat", "tries", "fast", "at_most", "tier", "base", "silent", "builds",
                               "hook", "line", "never"},
                              where);
  HostileSubmission s;
  s.name = object.at("name"), s.step = object.at("step"), s.threat = object.at("threat"), s.tries = object.at("tries");
  s.fast = object.at("fast"), s.at_most = object.at("at_most");
  s.needs_full = object.at("tier") == "full";
  s.skeleton = object.value("base", "solution") == "skeleton";
  s.silent = object.value("silent", false);
  s.builds = builds_of(object.value("builds", "yes"), where);
  s.hook = object.value("hook", ""), s.line = object.value("line", "hostile_hook();");
  s.never = object.value("never", std::vector<std::string>());
  return s;
}

/// The text with a line at the begin of a function's definition; nothing if the function is not in it.
std::optional<std::string> with_hook(const std::string& text, const std::string& function, const std::string& line) {
  for (std::size_t at = text.find(" " + function + "("); at != text.npos;
       at = text.find(" " + function + "(", at + 1)) {
    const std::size_t end = text.find('\n', at);
    if (end == text.npos || text.compare(end - 3, 3, ") {") != 0) continue;
    return text.substr(0, end + 1) + "  " + line + "\n" + text.substr(end + 1);
  }
  return std::nullopt;
}

bool is_code(const fs::path& file) {
  return file.extension() == ".cpp" || file.extension() == ".glsl";
}

/// The step's files, of the solution or of the skeleton.
std::map<std::string, std::string> files_of(const std::string& step, bool skeleton) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folders().solutions() / step)) {
    const std::string name = entry.path().filename().string();
    files[name] = read_file(skeleton ? folders().root / "steps" / step / name : entry.path());
  }
  return files;
}

/// Whether the step was not built, for what the compiler said or because a file is no text.
bool not_built(const json& step) {
  return std::all_of(step["cases"].begin(), step["cases"].end(), [&](const json& c) {
    const bool unusable = c["reason"].get<std::string>().find("all files of the step are needed") != std::string::npos;
    return c["status"] == "build_failed" || (c["status"] == "missing" && (unusable || step["build_log"] != ""));
  });
}

}  // namespace

std::vector<HostileSubmission> read_hostile_submissions() {
  const json all = json::parse(read_file(hostile_folder() / "hostile.json"));
  std::vector<HostileSubmission> submissions;
  for (const json& object : all.at("submissions")) submissions.push_back(submission_of(object));
  return submissions;
}

void write_hostile_submission(const HostileSubmission& submission, const fs::path& folder) {
  const fs::path own = hostile_folder() / submission.name;
  auto files = files_of(submission.step, submission.skeleton);
  bool hooked = submission.hook.empty();
  for (auto& [name, text] : files) {
    if (!is_code(name)) continue;
    if (!submission.hook.empty())
      if (auto changed = with_hook(text, submission.hook, submission.line)) text = *changed, hooked = true;
    const std::string extension = fs::path(name).extension().string();
    const fs::path front = own / ("front" + extension);
    if (!fs::exists(front)) continue;
    const std::string tools = extension == ".cpp" ? read_file(hostile_folder() / "tools.cpp") + "\n" : "";
    text = tools + read_file(front) + "\n" + text;
  }
  if (!hooked)
    throw Error(
        fmt::format("hostile.json: {}: {} has no function '{}'", submission.name, submission.step, submission.hook));
  for (auto& [name, text] : files) {
    if (fs::exists(own / name)) text = read_file(own / name);
    write_file(folder / submission.step / name, text);
  }
  if (fs::exists(own / "with")) fs::copy(own / "with", folder / submission.step, fs::copy_options::recursive);
}

void write_honest_submission(const std::string& step, const fs::path& folder, const std::string& comment) {
  for (const auto& [name, text] : files_of(step, false))
    write_file(folder / step / name, text + "// " + comment + "\n");
}

std::vector<std::string> found_in_results(const HostileSubmission& submission, const json& results,
                                          const fs::path& files, std::vector<std::string> forbidden) {
  std::vector<std::string> found;
  const auto is_its_own = [&](const json& step) { return step["step"] == submission.step; };
  const auto own = std::find_if(results.at("steps").begin(), results.at("steps").end(), is_its_own);
  if (own == results.at("steps").end()) return {"there is no result for its step"};
  const json& step = *own;
  const double score = step["score"], most = submission.at_most * step["max_score"].get<double>();
  if (score > most + 1e-6) found.push_back(fmt::format("it has got {} points, and may have {}", score, most));

  using Builds = HostileSubmission::Builds;
  const std::string log = step["build_log"];
  if (submission.builds != Builds::either && not_built(step) != (submission.builds == Builds::no))
    found.push_back((submission.builds == Builds::no ? "it was built" : "it was not built: ") + shorten(log, 2000));
  if (submission.builds == Builds::yes && !submission.silent &&
      step.dump(-1, ' ', false, json::error_handler_t::replace).find("attempted: " + submission.name) ==
          std::string::npos)
    found.push_back("nothing shows that it has tried anything");

  forbidden.push_back(hostile_success);
  forbidden.insert(forbidden.end(), submission.never.begin(), submission.never.end());
  for (const auto& [file, bytes] : files_with_bytes(files)) {
    for (const std::string& word : forbidden)
      if (const auto at = bytes.find(word); at != bytes.npos)
        found.push_back(
            fmt::format("{} has '{}': {}", file.filename().string(), word, printable(bytes.substr(at, 200))));
    if (const auto live = live_text(file, bytes)) found.push_back(*live);
  }
  return found;
}

std::optional<std::string> live_text(const fs::path& file, const std::string& bytes) {
  const std::string extension = file.extension().string();
  if (extension != ".html" && extension != ".xml" && extension != ".csv" && extension != ".json") return std::nullopt;
  const auto is_control = [](char c) { return (c >= 0 && c < 32 && c != '\n' && c != '\r' && c != '\t') || c == 127; };
  if (const auto at = std::find_if(bytes.begin(), bytes.end(), is_control); at != bytes.end())
    return fmt::format("{} has the control character {} at byte {}", file.filename().string(), int(*at),
                       at - bytes.begin());
  for (const char* reversed : {"\xe2\x80\xae", "\xc2\x9b"})
    if (bytes.find(reversed) != bytes.npos) return file.filename().string() + " has reversed text, or a C1 control";
  if (extension != ".html" && extension != ".xml") return std::nullopt;
  for (const char* live : {"<script>alert", "<img src=x", "<b>hostile"})
    if (bytes.find(live) != bytes.npos) return fmt::format("{} has live HTML: {}", file.filename().string(), live);
  return std::nullopt;
}

}  // namespace atelier::test
