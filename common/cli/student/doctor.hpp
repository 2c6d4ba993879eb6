// Findings of ./atelier doctor: facts about a machine, what is missing, and how to fix it.
//
// doctor_trials.hpp examines the machine; nothing here does, so every message can be tested on any machine.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/process.hpp"
#include "gl/context.hpp"
#include "sandbox/tier.hpp"

namespace atelier {

struct Finding {
  enum class State {
    good,  ///< found, and in order
    note,  ///< worth knowing; check and grade work without it
    lack,  ///< needed but missing
  } state = State::good;
  std::string subject;  ///< one word: "compiler"
  std::string words;    ///< what was found
  std::string fix;      ///< the command that fixes it; empty: none is known or needed
};

/// One line per finding: `good`, `note` or `lack`, the subject, the words and the fixing command, separated by tabs.
/// The launcher passes its findings in this format. Throws Error with a line that is invalid.
std::vector<Finding> parse_findings(const std::string& text);

/// 0 if nothing needed is missing, otherwise 1 (base/error.hpp).
int status_of(const std::vector<Finding>& findings);

/// One line per finding, after ✓, · or ✗, its fixing command below it, and a summary at the end.
std::string to_text(const std::vector<Finding>& findings);
/// {"ok": true, "findings": [{"state": "good", "subject": "compiler", "words": "...", "mend": ""}]}
std::string to_json(const std::vector<Finding>& findings);

/// The result of creating a context in a child process, since a broken driver may crash or hang.
struct ContextTrial {
  std::string version, renderer;  ///< OpenGL's strings; empty without a context
  std::string kind;               ///< "osmesa", "egl" or "window": the kind that the default selects
  std::optional<float> scale;     ///< content scale of a window; 2 on a high-DPI screen
  std::string failure;            ///< why it failed; empty: it works
  bool works() const { return failure.empty(); }
};

/// What the program prints about its context, for read_trial.
std::string trial_text(const ContextTrial& trial);
ContextTrial read_trial(const Finished& finished);

struct ContextTrials {
  ContextTrial osmesa, egl, window;
  ContextTrial headless;  ///< the judge's default
};

/// The three kinds, the one that the judge uses, and the window's scale. Only a judge without any context is a lack:
/// one kind is enough. `install` is the system's command for installing packages, without their names; empty: unknown.
std::vector<Finding> context_findings(const ContextTrials& trials, const std::string& install);

/// `x11` and `wayland`: the variables DISPLAY and WAYLAND_DISPLAY, empty if not set.
Finding display_finding(const std::string& x11, const std::string& wayland);

/// `reported`: whether the system reported a file that was written in the project's folder.
Finding watching_finding(bool reported);

struct SandboxTrial {
  sandbox::Possible possible;
  bool installed = false;  ///< bubblewrap is
  std::string setting;  ///< the kernel's setting that forbids it, as sysctl sets it: "user.max_user_namespaces=10000"
};
Finding sandbox_finding(const SandboxTrial& trial, const std::string& install);

struct StepTrial {
  std::string name;
  bool built = false;   ///< its program exists
  std::string failure;  ///< why it does not start; empty: it starts
};
/// One line for all steps that can be checked, and one for each step whose program is missing or does not start.
/// `build` is the build folder.
std::vector<Finding> step_findings(const std::vector<StepTrial>& trials, const ContextTrials& contexts,
                                   const std::string& build);

}  // namespace atelier
