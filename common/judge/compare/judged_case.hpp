// A case as the judge reads it: what the program must do, and how its answer is compared.
//
// tests/cases/NN-name/cases.json holds the cases of a step. tests/cases/README.md explains how to add one; this is the
// schema. Members without a default are required; unknown members are refused.
//
//   {"schema": 1, "step": "02-blinn-phong",
//    "defaults": {any member of a case but its name},       none; settings and camera are merged member by member
//    "cases": [CASE, ...]}
//
//   Of every CASE
//     "name"       [a-z0-9-]+, at most 64, unique
//     "title"      a few words for the report
//     "asked"      one sentence: what the picture or the numbers must be
//     "hint"       one sentence: what to try after a failure; optional for a case without points
//     "tier"       "core" (default), "further", "challenge"
//     "points"     0..1000
//     "student"    true (default); false if the untouched skeleton may pass
//     "hidden"     true if students do not get the case (cli/grader/release.cpp); false (default)
//     "rejects"    names of the mistakes that the case claims to catch; at least one if it has points
//     "functions"  names of the student's functions that the case tests
//     "needs"      optional driver features; such a case has no points
//     "settings"   {"shadow.resolution": 2048, ...}: those that differ from the program's defaults
//     "vary"       ranges of the numbers that are drawn anew for every submission (judge/compare/variation.hpp); not of
//                  a budget case or one that needs features; with a mask or regions, camera and size stay
//
//   Of a picture
//     "scene"      a built-in scene's name or a file
//     "camera"     {"eye": [x,y,z], "target", "up", "fov_y_degrees", "near", "far"}; absent members come from the scene
//     "size"       [width, height] pixels, 1..4096; [256, 256]
//     "output"     "colour" (default) or an intermediate that the program lists
//     "profile"    "strict" (default), "robust", "exact"
//     "unit"       "colour" (default), "encoded", "degrees", "number"; see Unit
//     "delta"      largest allowed difference of a pixel, in the unit: 3 for colours (default); required for degrees
//                  and numbers
//     "budget"     number of pixels that may exceed delta: 4
//     "exposure"   factor before clamping, colour only: 1
//     "mask"       [[x, y, width, height], ...]: areas that are not compared, at most a quarter of the picture
//     "regions"    [{"name", "at": [x, y, width, height], "weight"}, ...]: weights of areas for partial credit
//     "reason"     the reason for delta, budget, mask and choice; required if they are not the defaults
//     "truth_differs"  why the reference is not the ground truth of the program's --truth; only the project's own tests
//                  use it (tests/steps/truth.cpp)
//     "choice"     makes it a budget case (judge/compare/choice.hpp): the student chooses settings in choices.txt and
//                  gets points for a small error against the truth: {"settings": [names], "at_most": {count: limit},
//                  "error": "rmse", "flip", "misclassified", "distance", "degrees" or "wrong", "full": error,
//                  "none": error}; needs a reason
//     "references" accepted pictures in the folder of references: ["NAME.exr"]
//
//   Of a probe
//     "probe"      the function, as the program lists it
//     "inputs"     [{"eye": [x,y,z], "count": 3, ...}, ...]; a matrix is its columns in order
//     "numbers"    a name for each number of a result, for messages: ["eye.x", "GL_TEXTURE_WRAP_S: enum", ...]
//     "expected"   [[numbers of input 0], ...]; non-finite numbers as "nan", "inf", "-inf"; or
//     "expected_from": "reference"   the numbers are in NAME.values.json, written by ./atelier reference
//     "tolerance"  {"absolute", "relative", "ulp", "reason"}; without it numbers must be equal
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "judge/compare/choice.hpp"
#include "judge/compare/regions.hpp"
#include "judge/compare/variation.hpp"

namespace atelier::judge {

/// How two pictures or lists of numbers are compared (CONTRIBUTING.md, "Profiles").
enum class Profile {
  strict,  ///< few pixels exceed delta, they form no solid block, and the picture is not shifted
  robust,  ///< pixels outside the range of the reference's 3x3 neighbourhood form no solid block; hardly shifted
  exact,   ///< equal; colours after rounding to 8 bits
  values,  ///< numbers of a probe, each within its tolerance
};

/// The unit in which pixels differ.
enum class Unit {
  colour,   ///< linear colour: clamped to 0..1 after `exposure`, sRGB-encoded, differences in 1/255
  encoded,  ///< colour that is already encoded: clamped, differences in 1/255
  degrees,  ///< rgb is a direction n/2 + 1/2; the angle between both directions
  number,   ///< data: absolute difference per channel, in the data's unit
};

struct Tolerance {
  double absolute = 0, relative = 0;  ///< |yours - expected| <= absolute + relative |expected|
  int ulp = 0;                        ///< or at most this many 32-bit floats apart
  std::string reason;                 ///< why it is not smaller; required unless all three are 0
};

/// What a number of a probe's result means.
struct NumberName {
  std::string name;      ///< "eye.x"
  bool is_enum = false;  ///< of OpenGL: shown by its name
};

struct JudgedCase {
  Case ask;
  std::string title, asked, hint;
  double points = 0;
  std::string tier = "core";           ///< core, further, challenge
  bool student = true;                 ///< false: the untouched skeleton may pass (a background, a given part)
  bool hidden = false;                 ///< judged, but not in releases
  std::vector<std::string> rejects;    ///< the mistakes that this case claims to catch
  std::vector<std::string> functions;  ///< the student's functions that this case tests
  bool together = false;               ///< a probe: it tests these functions together, and no single one
  std::vector<std::string> needs;      ///< optional driver features ("clip_control"); such a case has no points
  std::optional<Variation> vary;       ///< what a grader's machine draws anew for every submission

  // Of a picture
  Profile profile = Profile::strict;
  Unit unit = Unit::colour;
  double delta = 3;              ///< in the unit: 1/255, degrees, or the data's unit
  int budget = 4;                ///< number of pixels that may exceed delta
  double exposure = 1;           ///< factor before clamping, colour only
  std::vector<Rectangle> mask;   ///< areas that are not compared; a NaN or an infinity there still fails
  std::vector<Region> regions;   ///< weights of areas for partial credit
  std::optional<Choice> choice;  ///< a budget case: judged by error against the truth and by cost, not by profile
  std::string reason;            ///< for delta, budget, mask and choice; required if they are not the defaults
  std::string truth_differs;     ///< why the reference is not what --truth traces; empty if it is
  std::vector<std::filesystem::path> references;  ///< accepted pictures, in the folder of references

  // Of a probe
  std::vector<NumberName> numbers;      ///< of each result, in order; empty: they have no names
  std::vector<Numbers> expected;        ///< one list per input; empty if they are in expected_file
  std::filesystem::path expected_file;  ///< NAME.values.json among the references, or empty
  Tolerance tolerance;
};

/// All cases of a step.
struct CaseFile {
  std::filesystem::path path;
  std::string step;  ///< "01-transforms"
  std::vector<JudgedCase> cases;
};

/// The students' functions that these cases name.
std::set<std::string> functions_of(const std::vector<JudgedCase>& cases);

/// The folder references/ beside a case file.
std::filesystem::path references_folder(const std::filesystem::path& case_file);

/// Reads and checks tests/cases/NN-name/cases.json. Throws Error naming the file, the case, the member, the value and
/// what is allowed. Does not read the references.
CaseFile read_case_file(const std::filesystem::path& path);

}  // namespace atelier::judge
