// How ./atelier doctor finds out: each trial asks the machine, is bounded in time, and leaves nothing behind.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/layout.hpp"
#include "cli/student/doctor.hpp"

namespace atelier {

/// Makes a context here and now: "osmesa", "egl", "window", or "headless" for what the judge takes where it is not
/// told. Throws Error where there is none. It is called in a program of its own.
ContextTrial try_context_here(const std::string& kind);

/// Makes each context in a child of this program, which has five seconds. The judge's own is made in the environment
/// that the judge gives to step programs.
ContextTrials try_contexts(const ProjectFolders& folders);

/// Whether the system tells within a second of a file that is written in `folder`, as inotify does on local disks and
/// does not on some network and shared folders. Throws Error where no file can be written there.
bool tells_of_writes(const std::filesystem::path& folder);

SandboxTrial try_sandbox();

/// Has each step's program print its list.
std::vector<StepTrial> try_steps(const ProjectFolders& folders, const std::vector<CourseStep>& course);

}  // namespace atelier
