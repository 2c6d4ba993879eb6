// The trials of ./atelier doctor: each examines the machine, has a time limit, and leaves nothing behind.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/layout.hpp"
#include "cli/student/doctor.hpp"

namespace atelier {

/// Creates a context in this process: "osmesa", "egl", "window", or "headless" for the judge's default. Throws Error if
/// that fails. Called in a child process.
ContextTrial try_context_here(const std::string& kind);

/// Creates each context in a child process, with a limit of five seconds. The judge's one is created in the environment
/// that the judge gives to step programs.
ContextTrials try_contexts(const ProjectFolders& folders);

/// Whether the system reports within a second a file that is written in `folder`. inotify does on local disks, but not
/// on some network and shared folders. Throws Error if no file can be written there.
bool reports_writes(const std::filesystem::path& folder);

SandboxTrial try_sandbox();

/// Runs each step's program with --list.
std::vector<StepTrial> try_steps(const ProjectFolders& folders, const std::vector<CourseStep>& course);

}  // namespace atelier
