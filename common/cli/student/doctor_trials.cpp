#include "cli/student/doctor_trials.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <fstream>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/file_watch.hpp"
#include "base/printable.hpp"
#include "judge/run/runner.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds trial_limit{5};  ///< a context takes 0.02 s, a step's list 0.05 s

/// The last line of a program's output.
std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return printable(text.substr(text.rfind('\n') + 1));
}

std::string in_words(const Finished& finished) {
  if (finished.timed_out) return fmt::format("it did not end within {} s", trial_limit.count());
  if (finished.signal != 0) return signal_name(finished.signal);
  const std::string last = last_line(finished.output);
  return last.empty() ? fmt::format("it ended with status {}", finished.exit_status) : last;
}

/// Kernel settings that forbid user namespaces: the file, the forbidding value, and the sysctl argument that allows
/// them.
struct Forbidding {
  const char *file, *value, *instead;
};
constexpr Forbidding forbidding[] = {
    {"/proc/sys/kernel/unprivileged_userns_clone", "0", "kernel.unprivileged_userns_clone=1"},
    {"/proc/sys/kernel/apparmor_restrict_unprivileged_userns", "1", "kernel.apparmor_restrict_unprivileged_userns=0"},
    {"/proc/sys/user/max_user_namespaces", "0", "user.max_user_namespaces=10000"},
};

std::string setting_in_the_way() {
  for (const Forbidding& row : forbidding) {
    std::ifstream file(row.file);
    if (std::string value; file >> value && value == row.value) return row.instead;
  }
  return "";
}

}  // namespace

ContextTrial try_context_here(const std::string& kind) {
  const auto context = kind == "headless" ? make_headless_context() : make_headless_context(parse_context_kind(kind));
  const auto text = [&](GLenum name) {
    const auto* words = reinterpret_cast<const char*>(context->gl().GetString(name));
    return printable(words ? words : "unknown");
  };
  ContextTrial trial{.version = text(GL_VERSION), .renderer = text(GL_RENDERER), .kind = to_string(context->kind())};
  if (context->kind() == ContextKind::window) trial.scale = window_content_scale();
  return trial;
}

ContextTrials try_contexts(const ProjectFolders& folders) {
  Command command{.arguments = {(folders.build / "bin" / "atelier").string(), "doctor", "--try", ""},
                  .time_limit = trial_limit};
  const auto result_of = [&](const char* kind) {
    command.arguments.back() = kind;
    return read_trial(run_process(command));
  };
  ContextTrials trials{.osmesa = result_of("osmesa"), .egl = result_of("egl"), .window = result_of("window")};
  command.environment = judge::program_environment({});
  trials.headless = result_of("headless");
  return trials;
}

bool reports_writes(const fs::path& folder) {
  const fs::path file = folder / fmt::format(".atelier-doctor-{}", ::getpid());
  const FileWatch watch({file});
  write_file(file, std::string_view("atelier doctor tests whether the system reports this file\n"));
  std::error_code ignored;
  fs::remove(file, ignored);
  pollfd event{watch.descriptor(), POLLIN, 0};  // poll ignores -1
  return ::poll(&event, 1, 1000) == 1;
}

SandboxTrial try_sandbox() {
  SandboxTrial trial{.possible = sandbox::find_possible_tiers(), .installed = fs::exists("/usr/bin/bwrap")};
  if (trial.installed && trial.possible.best != sandbox::Tier::full) trial.setting = setting_in_the_way();
  return trial;
}

std::vector<StepTrial> try_steps(const ProjectFolders& folders, const std::vector<CourseStep>& course) {
  std::vector<StepTrial> trials;
  for (const CourseStep& step : course) {
    StepTrial trial{.name = step.name, .built = fs::exists(folders.program(step.name))};
    if (trial.built) {
      const Finished finished =
          run_process({.arguments = {folders.program(step.name).string(), "--list"}, .time_limit = trial_limit});
      if (!finished.ok()) trial.failure = in_words(finished);
    }
    trials.push_back(trial);
  }
  return trials;
}

}  // namespace atelier
