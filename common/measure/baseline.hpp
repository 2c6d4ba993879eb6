// A step's program beside a baseline, another program that draws the same scene: how much faster, and how far each is
// from the truth. tests/cases/NN-name/baseline.json says what is compared; every member stands in
// tests/cases/README.md.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "measure/program.hpp"

namespace atelier::measure {

struct BaselineRow {
  std::string name;
  std::map<std::string, SettingValue> settings;
  std::map<std::string, SettingValue> baseline_settings;  ///< what the baseline is drawn with beside it
  double aim = 0;                                         ///< times as fast as the baseline; 0: nothing is aimed at
  bool no_larger_error = false;                           ///< whether that is meant at no larger error
};

struct BaselinePlan {
  std::string program, scene;
  glm::ivec2 size{256, 256};
  std::string shadow;
  int samples = 1;
  std::vector<BaselineRow> rows;
};

/// Reads the text of a baseline.json; `where` starts every error sentence. Throws Error naming the member and what is
/// allowed.
BaselinePlan parse_baseline_plan(std::string_view text, const std::string& where);
BaselinePlan read_baseline_plan(const std::filesystem::path& file);  ///< the same, of a file

/// What came out of one program under its settings. Errors are against the truth of the scene, traced.
struct Compared {
  std::string name;
  std::size_t against = 0;                ///< of a row: which of the baselines it was drawn beside
  double seconds = 0;                     ///< of a frame: the median over the rounds of each round's median
  double ratio = 1, least = 1, most = 1;  ///< the baseline's time over this one's, round by round: median and range
  double rmse = 0;                        ///< of the colours
  double wrong = 0;                       ///< pixels whose shadow is wrong, of all: ErrorMetric::wrong
};

/// The baseline under each of the settings that rows ask of it, in their order, and the rows.
struct BaselineComparison {
  std::vector<Compared> baselines, rows;
};

/// In each round the baseline is drawn right before each row, `frames` times each,
/// and the two are compared with each other alone: what slows a machine down for a while slows down both.
BaselineComparison compare_with_baseline(const BaselinePlan& plan, const Program& step, const Program& baseline,
                                         int rounds, int frames);

/// Whether the row does what it aims at; `baseline` is the one that it was drawn beside. Errors are equal
/// where they differ by less than 1 %.
bool reaches_aim(const BaselineRow& row, const Compared& compared, const Compared& baseline);

}  // namespace atelier::measure
