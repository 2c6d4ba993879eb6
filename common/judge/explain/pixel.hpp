// One pixel of a picture case: every intermediate result there, yours beside the right one, and the first that differs.
// An error in a surface's position changes its normal, its light and its colour, so the first is the one to look at.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "case/output.hpp"
#include "judge/compare/answer.hpp"
#include "judge/compare/judged_case.hpp"

namespace atelier::judge {

/// The outputs that lead to the output `own`, in the order of the pipeline, `own` last. Outputs of another view, and
/// those that are not on the way to it, are left out. Throws Error naming the outputs if `own` is not among them.
std::vector<OutputSpec> pipeline_to(const std::string& own, const std::vector<OutputSpec>& outputs);

/// How a pixel of this output is compared: in the case's own unit and tolerance if the case judges the output, else as
/// the first of the step's other cases that does, else in the unit of such outputs with a usual tolerance: 3/255 for a
/// colour, 0.5 degrees for a normal, 0.01 m for a position, 0.0001 for a depth, 0.002 for other data. A direction is
/// always compared in degrees.
JudgedCase comparison_of(const OutputSpec& output, const JudgedCase& c, const std::vector<JudgedCase>& step);

/// What a value is compared with.
enum class Beside {
  solution,   ///< the solution's pixel
  reference,  ///< the stored reference's pixel
  truth,      ///< the ray-traced ground truth; near edges its range over the 3x3 pixels around, as in robust profiles
};
std::string to_string(Beside beside);  ///< "solution" ...

/// One output at the pixel. Values are as a program writes them: linear or encoded colour, a direction as n/2 + 1/2.
struct PixelRow {
  std::string output;
  Stage stage = Stage::light;
  JudgedCase how;             ///< it is compared in this unit, with this tolerance and exposure
  std::optional<Rgba> yours;  ///< none: `problem` says why
  std::optional<Rgba> right;  ///< none: nothing is known to compare with
  Beside beside = Beside::solution;
  double apart = 0;  ///< in the unit; infinite if yours is not finite
  bool differs = false;
  std::string problem;  ///< "crashed: ..."

  double tolerance() const { return how.profile == Profile::exact ? 0 : how.delta; }  ///< in the unit
};

/// What the values are compared with: pictures of the case's size.
struct RightPictures {
  Beside beside = Beside::solution;
  std::vector<const Image*> pictures;  ///< each is right; none: nothing to compare with
};

/// Compares one output at one pixel. `how` is from comparison_of; `yours` must be an answer to that output.
PixelRow compare_pixel(const OutputSpec& output, const JudgedCase& how, const Answer& yours, const RightPictures& right,
                       Position at);

/// What is visible at the pixel, by the ground truth.
enum class Visible { unknown, background, surface, edge };  ///< edge: a neighbouring pixel shows something else

/// `things`: the ground truth's output "thing", 0 where nothing is seen.
Visible visible_at(const Image& things, Position at);

struct PixelReport {
  std::string step, case_name, title;
  Position at;
  glm::ivec2 size{0};
  std::string scene;
  std::map<std::string, SettingValue> settings;  ///< those that differ from the defaults
  std::map<std::string, std::string> implementations;
  Visible visible = Visible::unknown;
  bool masked = false;                 ///< the case does not compare this pixel
  std::string region;                  ///< its part of the picture that has a weight of its own; empty: none
  std::vector<PixelRow> rows;          ///< in the order of the pipeline, the case's own output last
  std::string functions_of;            ///< the step that has `functions`
  std::vector<std::string> functions;  ///< that make the first output that differs
  std::string truth_differs;           ///< why the ground truth is not what a right step draws; empty: it is
  std::optional<Position> worst;  ///< where the case's own output differs most; none if no pixel is out of tolerance
};

/// Whether the program answered no output at all: it does not compile, crashes or hangs.
bool drew_nothing(const PixelReport& report);

/// The first row that differs; none if the program drew nothing.
const PixelRow* first_to_differ(const PixelReport& report);

/// The functions that make an output, by the cases that judge it: of `c` itself if it is its own output, else of all
/// cases that show it, as far as `c` tests them or needs them (`needs`; empty: unknown).
std::vector<std::string> functions_behind(const std::string& output, const JudgedCase& c,
                                          const std::vector<std::string>& needs, const std::vector<JudgedCase>& step);

/// One or more plain sentences: which output is the first to differ, by how much, and in which functions to look.
std::string pixel_sentence(const PixelReport& report);

}  // namespace atelier::judge
