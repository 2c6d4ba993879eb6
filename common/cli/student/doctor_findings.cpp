#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>

#include "base/error.hpp"
#include "base/near_names.hpp"
#include "base/printable.hpp"
#include "cli/student/doctor.hpp"

namespace atelier {
namespace {

using State = Finding::State;

struct StateName {
  State state;
  const char *word, *mark;
};
constexpr StateName states[] = {{State::good, "good", "✓"}, {State::note, "note", "·"}, {State::lack, "lack", "✗"}};

const StateName& name_of(State state) {
  return *std::find_if(std::begin(states), std::end(states), [&](const auto& s) { return s.state == state; });
}

Finding parse_finding(const std::string& line) {
  std::array<std::string, 4> parts;
  std::istringstream text(line);
  std::size_t count = 0;
  while (count < parts.size() && std::getline(text, parts[count], '\t')) ++count;
  const auto state =
      std::find_if(std::begin(states), std::end(states), [&](const auto& s) { return s.word == parts[0]; });
  if (state == std::end(states) || count < 3)
    throw Error(
        fmt::format("'{}' is not a finding: it takes good, note or lack, a subject, words and a command, with tabs "
                    "between",
                    printable(line)));
  return {state->state, parts[1], parts[2], parts[3]};
}

/// The packages of Mesa's software driver for EGL, for the system with the command `install`.
std::string mesa_packages(const std::string& install) {
  if (install.find("dnf") != std::string::npos) return "mesa-libEGL mesa-dri-drivers";
  if (install.find("pacman") != std::string::npos) return "mesa";
  return "libegl1 libegl-mesa0 libgl1-mesa-dri";
}

std::string with_packages(const std::string& install, const std::string& packages) {
  return install.empty() ? "" : install + " " + packages;
}

Finding kind_finding(const std::string& subject, const ContextTrial& trial) {
  if (!trial.works()) return {State::note, subject, trial.failure, ""};
  return {State::good, subject, fmt::format("OpenGL {}, {}", trial.version, trial.renderer), ""};
}

Finding judge_finding(const ContextTrial& headless, const std::string& install) {
  if (!headless.works())
    return {State::lack, "judge", "nothing can be drawn: of osmesa, egl and window none gives OpenGL 3.3",
            with_packages(install, mesa_packages(install))};
  if (headless.renderer.find("llvmpipe") != std::string::npos)
    return {State::good, "judge", fmt::format("draws with {} by llvmpipe, like the references", headless.kind), ""};
  return {State::note, "judge",
          fmt::format("draws with {} by {}, but the references were drawn by llvmpipe: verdicts on edges may differ "
                      "from the grader's, which counts",
                      headless.kind, headless.renderer),
          with_packages(install, mesa_packages(install))};
}

}  // namespace

std::vector<Finding> parse_findings(const std::string& text) {
  std::vector<Finding> findings;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) findings.push_back(parse_finding(line));
  return findings;
}

int status_of(const std::vector<Finding>& findings) {
  const auto lacks = [](const Finding& finding) { return finding.state == State::lack; };
  return std::any_of(findings.begin(), findings.end(), lacks) ? exit_failed : exit_ok;
}

std::string to_text(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings) {
    text += fmt::format("{} {:<10} {}\n", name_of(finding.state).mark, finding.subject, finding.words);
    if (!finding.fix.empty()) text += fmt::format("{:13}fix: {}\n", "", finding.fix);
  }
  return text + (status_of(findings) == exit_ok ? "\nEverything needed is installed.\n"
                                                : "\nSomething that is needed is missing: see the lines with ✗.\n");
}

std::string to_json(const std::vector<Finding>& findings) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Finding& finding : findings)
    list.push_back({{"state", name_of(finding.state).word},
                    {"subject", finding.subject},
                    {"words", finding.words},
                    {"mend", finding.fix}});
  return nlohmann::ordered_json{{"ok", status_of(findings) == exit_ok}, {"findings", list}}.dump(2) + "\n";
}

// A driver may print other lines around ours, so each of ours begins with a fixed word.
std::string trial_text(const ContextTrial& trial) {
  std::string text =
      fmt::format("trial version {}\ntrial renderer {}\ntrial kind {}\n", trial.version, trial.renderer, trial.kind);
  if (trial.scale) text += fmt::format("trial scale {}\n", *trial.scale);
  return text;
}

ContextTrial read_trial(const Finished& finished) {
  ContextTrial trial;
  std::string error;
  std::istringstream lines(finished.output);
  for (std::string line; std::getline(lines, line);) {
    const auto rest_of = [&](std::string_view begin, std::string& rest) {
      if (line.starts_with(begin)) rest = printable(line.substr(begin.size()));
    };
    std::string scale;
    rest_of("error: ", error);
    rest_of("trial version ", trial.version);
    rest_of("trial renderer ", trial.renderer);
    rest_of("trial kind ", trial.kind);
    rest_of("trial scale ", scale);
    if (!scale.empty()) trial.scale = std::strtof(scale.c_str(), nullptr);
  }
  if (finished.timed_out)
    trial.failure = fmt::format("the driver did not answer within {:.0f} s", finished.seconds);
  else if (finished.signal != 0)
    trial.failure = "the driver crashed: " + signal_name(finished.signal);
  else if (finished.exit_status != exit_ok)
    trial.failure = error.empty() ? fmt::format("the trial ended with status {}", finished.exit_status) : error;
  else if (trial.version.empty())
    trial.failure = "the trial printed nothing";
  return trial;
}

std::vector<Finding> context_findings(const ContextTrials& trials, const std::string& install) {
  std::vector<Finding> findings = {kind_finding("osmesa", trials.osmesa), kind_finding("egl", trials.egl),
                                   kind_finding("window", trials.window), judge_finding(trials.headless, install)};
  if (trials.window.scale)
    findings.push_back({State::good, "scale", fmt::format("{} (content scale)", *trials.window.scale), ""});
  return findings;
}

Finding display_finding(const std::string& x11, const std::string& wayland) {
  if (x11.empty() && wayland.empty())
    return {State::note, "display",
            "none (neither DISPLAY nor WAYLAND_DISPLAY is set): ./atelier run needs one, check and grade do not", ""};
  std::vector<std::string> servers;
  if (!x11.empty()) servers.push_back("X11 " + printable(x11));
  if (!wayland.empty()) servers.push_back("Wayland " + printable(wayland));
  return {State::good, "display", join(servers), ""};
}

Finding watching_finding(bool reported) {
  if (reported) return {State::good, "watching", "the system reports files that are saved in steps/ at once", ""};
  return {State::note, "watching",
          "the system does not report files that are saved in steps/: watch and the window check them every 200 ms",
          ""};
}

Finding sandbox_finding(const SandboxTrial& trial, const std::string& install) {
  const auto& [best, why_not_full, why_not_account] = trial.possible;
  if (best == sandbox::Tier::full)
    return {State::good, "sandbox", "full: strangers' work is graded in namespaces of its own", ""};
  std::string fix = trial.setting.empty() ? "" : "sudo sysctl " + trial.setting;
  if (!trial.installed) fix = with_packages(install, "bubblewrap");
  if (best == sandbox::Tier::account)
    return {State::note, "sandbox",
            fmt::format("account: strangers' work is graded under an account of its own, but in no namespaces ({})",
                        why_not_full),
            fix};
  return {
      State::note, "sandbox",
      fmt::format("none: strangers' work is not graded here (full: {}; account: {})", why_not_full, why_not_account),
      fix};
}

std::vector<Finding> step_findings(const std::vector<StepTrial>& trials, const ContextTrials& contexts,
                                   const std::string& build) {
  std::vector<Finding> broken;
  std::vector<std::string> ready;
  for (const StepTrial& trial : trials) {
    if (!trial.built)
      broken.push_back({State::lack, "steps", trial.name + " is not built", "./atelier list"});
    else if (trial.failure.find("is not built yet") != std::string::npos)
      broken.push_back({State::note, "steps", fmt::format("{}: your code is not built yet", trial.name),
                        fmt::format("./atelier check {}", trial.name.substr(0, 2))});
    else if (!trial.failure.empty())
      broken.push_back({State::lack, "steps", fmt::format("{} does not start: {}", trial.name, trial.failure),
                        fmt::format("rm -r '{}' && ./atelier list", build)});
    else
      ready.push_back(trial.name);
  }
  std::vector<Finding> findings;
  if (!ready.empty() && contexts.headless.works())
    findings.push_back({State::good, "steps",
                        fmt::format("{} can be checked here{}", join(ready),
                                    contexts.window.works() ? ", and run in a window" : ", not run in a window"),
                        ""});
  findings.insert(findings.end(), broken.begin(), broken.end());
  return findings;
}

}  // namespace atelier
