// Compares a step's program with a baseline, another program that draws the same scene: speed and error.
// tests/cases/NN-name/baseline.json says what is compared; tests/cases/README.md describes its members.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "image/error.hpp"
#include "measure/program.hpp"

namespace atelier::measure {

struct BaselineRow {
  std::string name;
  std::map<std::string, SettingValue> settings;           ///< with the plan's
  std::map<std::string, SettingValue> baseline_settings;  ///< the baseline's settings in this comparison
  double aim = 0;                                         ///< the speed-up to reach over the baseline; 0: no aim
  bool no_larger_error = false;                           ///< whether the aim also requires an error no larger
};

struct BaselinePlan {
  std::string program, scene;
  glm::ivec2 size{256, 256};
  std::map<std::string, SettingValue> settings;  ///< of the step's program, in every row and in the ground truth
  std::string output;                      ///< the output of both programs whose error is measured besides colour's
  ErrorMetric metric = ErrorMetric::rmse;  ///< of that output
  int samples = 1;
  std::vector<BaselineRow> rows;
};

/// Parses a baseline.json; every error message begins with `where`. Throws Error naming the member and what is allowed.
BaselinePlan parse_baseline_plan(std::string_view text, const std::string& where);
BaselinePlan read_baseline_plan(const std::filesystem::path& file);  ///< the same, from a file

/// The results of one program with its settings. Errors are against the traced ground truth of the scene.
struct Compared {
  std::string name;
  std::size_t against = 0;                ///< of a row: index of the baseline it is compared with
  double seconds = 0;                     ///< per frame: the median over the rounds of each round's median
  double ratio = 1, least = 1, most = 1;  ///< the baseline's time / this one's, per round: median and range
  double rmse = 0;                        ///< of the colours
  double error = 0;                       ///< of the plan's output, by the plan's metric
};

/// The baseline with each of the settings that rows name, in their order, and the rows.
struct BaselineComparison {
  std::vector<Compared> baselines, rows;
};

/// In each round draws the baseline right before each row, `frames` times each, and compares only these two times. So a
/// temporary slowdown of the machine affects both.
BaselineComparison compare_with_baseline(const BaselinePlan& plan, const Program& step, const Program& baseline,
                                         int rounds, int frames);

/// Whether the row reaches its aim; `baseline` is the one it is compared with. An error up to 1 % larger counts as
/// equal.
bool reaches_aim(const BaselineRow& row, const Compared& compared, const Compared& baseline);

}  // namespace atelier::measure
