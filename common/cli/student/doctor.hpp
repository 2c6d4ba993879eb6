// What ./atelier doctor says: facts about a machine, turned into findings that name what lacks and what mends it.
//
// Finding out is done elsewhere (doctor_trials.hpp); nothing here asks the machine, so that every sentence can be
// tested on machines that are not at hand.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/process.hpp"
#include "gl/context.hpp"

namespace atelier {

struct Finding {
  enum class State {
    good,  ///< there, and as it should be
    note,  ///< worth knowing; check and grade work without it
    lack,  ///< needed, and not there
  } state = State::good;
  std::string subject;  ///< one word: "compiler"
  std::string words;    ///< what was found
  std::string mend;     ///< the command that mends it; empty: none is known, or none is needed
};

/// A line each: `good`, `note` or `lack`, the subject, the words and the mending command, with tabs between. This is
/// how the launcher hands over what it found before anything was built. Throws Error with the line that is none.
std::vector<Finding> parse_findings(const std::string& text);

/// 0 where nothing that is needed lacks, otherwise 1 (base/error.hpp).
int status_of(const std::vector<Finding>& findings);

/// One finding a line behind ✓, · or ✗, its mending command below it, and a last line that sums up.
std::string to_text(const std::vector<Finding>& findings);
/// {"ok": true, "findings": [{"state": "good", "subject": "compiler", "words": "...", "mend": ""}]}
std::string to_json(const std::vector<Finding>& findings);

/// What came of making a context in a program of its own, since a broken driver may crash or hang.
struct ContextTrial {
  std::string version, renderer;  ///< OpenGL's own words; empty where there is no context
  std::string kind;               ///< "osmesa", "egl" or "window": what the default turned out to be
  std::optional<float> scale;     ///< of a window: pixels of its screen for a unit of design; 2 on a fine screen
  std::string failure;            ///< why there is none; empty: there is one
  bool works() const { return failure.empty(); }
};

/// What the program prints about its context, for read_trial.
std::string trial_text(const ContextTrial& trial);
ContextTrial read_trial(const Finished& finished);

struct ContextTrials {
  ContextTrial osmesa, egl, window;
  ContextTrial headless;  ///< what the judge takes where it is not told
};

/// The three kinds, what the judge draws with, and the window's scale. Only that the judge has nothing to draw with is
/// a lack: one kind is enough. `install` is the system's command for installing packages, without their names; empty:
/// unknown.
std::vector<Finding> context_findings(const ContextTrials& trials, const std::string& install);

/// `x11` and `wayland`: the variables DISPLAY and WAYLAND_DISPLAY, empty where they are not set.
Finding display_finding(const std::string& x11, const std::string& wayland);

/// Whether the system has told of a file that was written in the project's folder.
Finding watching_finding(bool told);

struct SandboxTrial {
  bool installed = false;  ///< bubblewrap is there
  bool works = false;      ///< and has started a program in namespaces of its own
  bool as_root = false;    ///< which root may always do, so that nothing is known about other users
  std::string words;       ///< what it said where it has not
  std::string setting;  ///< the kernel's setting that forbids it, as sysctl sets it: "user.max_user_namespaces=10000"
};
Finding sandbox_finding(const SandboxTrial& trial, const std::string& install);

struct StepTrial {
  std::string name;
  bool built = false;   ///< its program is there
  std::string failure;  ///< why it does not start; empty: it does
};
/// A line for all that can be checked here, and one for each step whose program is missing or does not start. `build`
/// is the build folder.
std::vector<Finding> step_findings(const std::vector<StepTrial>& trials, const ContextTrials& contexts,
                                   const std::string& build);

}  // namespace atelier
