// A step's program beside a baseline, another program that draws the same scene: how much faster, and how far each is
// from the truth. tests/cases/NN-name/baseline.json says what is compared:
//
//   {
//     "baseline": "shadow-demo",            the program: BUILD/bin/shadow-demo, from tests/baselines
//     "scene": "cubes", "size": [800, 600], the picture; all programs take the scene's own camera
//     "shadow": "shadow_factor",            the output whose wrong pixels are counted
//     "samples": 4,                         n x n rays a pixel of the true colours, 1..64
//     "rows": [{"name": "tight fit", "settings": {...}, "aim": 1.5, "no_larger_error": true}, ...]
//   }
//
// A row's `aim`, absent where there is none, is how many times as fast as the baseline it is meant to be.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "measure/program.hpp"

namespace atelier::measure {

struct BaselineRow {
  std::string name;
  std::map<std::string, SettingValue> settings;
  double aim = 0;                ///< times as fast as the baseline; 0: nothing is aimed at
  bool no_larger_error = false;  ///< whether that is meant at no larger error
};

struct BaselinePlan {
  std::string program, scene;
  glm::ivec2 size{256, 256};
  std::string shadow;
  int samples = 1;
  std::vector<BaselineRow> rows;
};

/// Throws Error naming the file, the member and what is allowed.
BaselinePlan read_baseline_plan(const std::filesystem::path& file);

/// What came out of one program. Errors are against the truth of the scene, traced.
struct Compared {
  std::string name;
  double seconds = 0;                     ///< of a frame: the median over the rounds of each round's median
  double ratio = 1, least = 1, most = 1;  ///< the baseline's time over this one's, round by round: median and range
  double rmse = 0;                        ///< of the colours
  double wrong = 0;                       ///< pixels whose shadow is wrong, of all: ErrorMetric::wrong
};

/// The baseline first, then the rows. In each round the baseline is drawn right before each row, `frames` times each,
/// and the two are compared with each other alone: what slows a machine down for a while slows down both.
std::vector<Compared> compare_with_baseline(const BaselinePlan& plan, const Program& step, const Program& baseline,
                                            int rounds, int frames);

/// Whether the row does what it aims at; `baseline` is the first that compare_with_baseline returned. Errors are equal
/// where they differ by less than 1 %.
bool reaches_aim(const BaselineRow& row, const Compared& compared, const Compared& baseline);

}  // namespace atelier::measure
