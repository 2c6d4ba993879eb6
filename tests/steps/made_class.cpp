#include "made_class.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/launch.hpp"
#include "catch.hpp"
#include "command.hpp"
#include "running.hpp"

namespace atelier::test {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

std::string solution(const std::string& file) {
  return read_file(folders().solutions() / file);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  REQUIRE(text.find(from) != text.npos);
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace

std::set<std::string> abandoned_groups() {
  std::string space = fs::read_symlink("/proc/self/ns/pid").string();
  std::erase_if(space, [](char c) { return c < '0' || c > '9'; });
  const std::string prefix = "atelier-" + space + "-";
  std::set<std::string> found;
  std::error_code error;
  for (fs::recursive_directory_iterator entry("/sys/fs/cgroup", error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with(prefix) && ::kill(std::stoi(name.substr(prefix.size())), 0) != 0)
      found.insert(entry->path().string());
  }
  return found;
}

MadeClass::MadeClass()
    : class_(all_.path() / "class"), temporary_(all_.path() / "tmp"), groups_of_others_(abandoned_groups()) {
  fs::create_directory(temporary_);
  fs::permissions(all_.path(), fs::perms(0755));  // confined programs go through it
  const std::string hello = solution("00-hello/hello.glsl"), transforms = solution("01-transforms/transforms.cpp");
  const auto hand_in = [&](const std::string& student, const std::string& step, const std::string& code) {
    for (const CourseStep& each : read_course(folders().step_flags()))
      if (each.name == step)
        for (const std::string& file : each.files) {
          const bool own = file == "hello.glsl" || file == "transforms.cpp";
          write_file(class_ / student / step / file, (own ? code : solution(step + "/" + file)) +
                                                         (file == "choices.txt" ? "" : "// " + student + "\n"));
        }
  };
  hand_in("ada", "00-hello", hello);
  hand_in("ada", "01-transforms", transforms);
  hand_in("bob", "01-transforms", transforms);
  hand_in("cy", "01-transforms", replaced(transforms, "return", "not C++"));
  hand_in("dan", "00-hello", replaced(hello, "return weights;", "return 0.5 * weights;"));
  hand_in("eve", "00-hello", replaced(hello, "return weights;", "return wieghts;"));
  hand_in("fay", "01-transforms", replaced(transforms, "cos(", "sin("));
}

std::vector<std::string> MadeClass::students() {
  return {"ada", "bob", "cy", "dan", "eve", "fay"};
}

void MadeClass::change(const std::string& student) const {
  for (const auto& entry : fs::recursive_directory_iterator(class_ / student))
    if (entry.path().extension() == ".cpp" || entry.path().extension() == ".glsl") {
      write_file(entry.path(), read_file(entry.path()) + "// changed\n");
      return;
    }
}

std::vector<std::string> MadeClass::command(const fs::path& out, const std::vector<std::string>& more) const {
  std::vector<std::string> arguments = {(folders().build / "bin" / "atelier").string(), "grade", class_.string(),
                                        "--out", out.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  if (std::ranges::find(more, "--step") == more.end())
    arguments.insert(arguments.end(), {"--step", "00", "--step", "01"});
  return arguments;
}

std::map<std::string, std::string> MadeClass::environment() const {
  std::map<std::string, std::string> environment = own_environment();
  environment["TMPDIR"] = temporary_.string();
  return environment;
}

std::map<std::string, std::string> class_verdicts(const fs::path& out) {
  std::map<std::string, std::string> found = {{"gradebook.csv", read_file(out / "gradebook.csv")}};
  for (const auto& entry : fs::directory_iterator(out / "students")) {
    std::string& text = found["students/" + entry.path().filename().string()];
    const json record = json::parse(read_file(entry.path() / "record.json"));
    text = record["needs_human"].dump() + "\n";
    if (!fs::exists(entry.path() / "results.json")) continue;
    const json results = json::parse(read_file(entry.path() / "results.json"));
    for (const json& step : results["steps"])
      for (const json& c : step["cases"])
        text +=
            fmt::format("{} {} {} {}\n", step["step"].dump(), c["name"].dump(), c["status"].dump(), c["score"].dump());
  }
  return found;
}

std::optional<std::string> stamp_of_graded(const fs::path& out, const std::string& student) {
  struct stat report {};
  const fs::path folder = out / "students" / student;
  if (!fs::exists(folder / "record.json") || ::stat((folder / "report.html").c_str(), &report) != 0) return {};
  return fmt::format("{} {} {}", report.st_ino, report.st_mtim.tv_sec, report.st_mtim.tv_nsec);
}

std::vector<std::string> leavings(const MadeClass& made, const fs::path& out) {
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(out)) {
    const fs::path& path = entry.path();
    const std::string name = path.filename().string();
    if (name.starts_with(".atelier-") || name.ends_with(".new") || name.starts_with("worker-"))
      found.push_back("file " + path.string());
    if (path.extension() == ".json" && !json::accept(read_file(path))) found.push_back("no JSON: " + path.string());
  }
  for (const auto& entry : fs::directory_iterator(made.temporary())) found.push_back(entry.path().string());
  // What was killed takes a moment to be gone.
  const std::string where = made.place("").string();
  std::set<std::string> groups;
  const auto is_clean = [&] {
    groups = abandoned_groups();
    for (const std::string& group : made.groups_of_others()) groups.erase(group);
    return groups.empty() && processes_with(where).empty();
  };
  comes_true(is_clean, 5);
  for (const FoundProcess& process : processes_with(where)) found.push_back("process " + process.words);
  for (const std::string& group : groups) found.push_back("control group " + group);
  return found;
}

}  // namespace atelier::test
