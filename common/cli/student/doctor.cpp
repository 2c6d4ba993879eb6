// ./atelier doctor: what is installed, what is missing, and the command that fixes it.
//
// The launcher checks what needs no build (common/cli/student/doctor.sh), and passes on its findings.
#include "cli/student/doctor.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/layout.hpp"
#include "cli/student/doctor_trials.hpp"

namespace atelier {
namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

Finding try_watching(const std::filesystem::path& folder) {
  try {
    return watching_finding(reports_writes(folder));
  } catch (const Error& error) {
    return {Finding::State::lack, "folder", error.what(), fmt::format("sudo chown -R \"$USER\" '{}'", folder.string())};
  }
}

std::vector<Finding> examine(const DoctorOptions& options) {
  const ProjectFolders folders = project_folders();
  std::vector<Finding> findings = parse_findings(options.found);
  const auto add = [&](const std::vector<Finding>& more) { findings.insert(findings.end(), more.begin(), more.end()); };

  const ContextTrials contexts = try_contexts(folders);
  add({display_finding(variable("DISPLAY"), variable("WAYLAND_DISPLAY"))});
  add(context_findings(contexts, options.install));
  add({try_watching(folders.steps()), sandbox_finding(try_sandbox(), options.install)});
  add(step_findings(try_steps(folders, read_course(folders.step_flags())), contexts, folders.build.string()));
  return findings;
}

}  // namespace

int run_doctor(const DoctorOptions& options) {
  if (!options.context.empty()) {
    fmt::print("{}", trial_text(try_context_here(options.context)));
    return exit_ok;
  }
  const std::vector<Finding> findings = examine(options);
  fmt::print("{}", options.json ? to_json(findings) : to_text(findings));
  return status_of(findings);
}

}  // namespace atelier
