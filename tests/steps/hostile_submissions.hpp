// The submissions of tests/hostile: solutions and skeletons with an attack in them. The format is in its README.md.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace atelier::test {

struct HostileSubmission {
  enum class Builds { yes, no, either };
  std::string name, step, threat, tries;
  bool fast = false;        ///< in the usual tier of tests
  double at_most = 0;       ///< share of the step's points that it may get
  bool needs_full = false;  ///< contained by the full sandbox alone
  bool skeleton = false;    ///< what it does not change is the skeleton's, not the solution's
  bool silent = false;      ///< cannot say that it has tried
  Builds builds = Builds::yes;
  std::string hook, line;          ///< the function that begins with this line; empty: none
  std::vector<std::string> never;  ///< must be in no result, besides what no result may have
};

std::vector<HostileSubmission> read_hostile_submissions();

/// Writes its files to `folder`/NN-name.
void write_hostile_submission(const HostileSubmission& submission, const std::filesystem::path& folder);

/// The solution of a step to `folder`/NN-name, with a comment at the end of each of its files.
void write_honest_submission(const std::string& step, const std::filesystem::path& folder, const std::string& comment);

/// What is wrong with the results of one that is contained, a sentence each; `results` is its results.json, `files` is
/// the folder of all its results, and `forbidden` is in none of them.
std::vector<std::string> found_in_results(const HostileSubmission& submission, const nlohmann::json& results,
                                          const std::filesystem::path& files, std::vector<std::string> forbidden);

/// What is in a file of results that no student may write there: controls of terminals, and live HTML.
std::optional<std::string> live_text(const std::filesystem::path& file, const std::string& bytes);

}  // namespace atelier::test
