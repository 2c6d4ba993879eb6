// A case as the judge knows it: what the program is asked, and what is thought of the answer.
//
// tests/cases/NN-name/cases.json holds the cases of a step. tests/cases/README.md explains how to add one; this is the
// schema. Members without a default must be there; every other member is refused.
//
//   {"schema": 1, "step": "02-blinn-phong", "title": TEXT,
//    "defaults": {any member of a case but its name},       none; settings and camera are completed member by member
//    "cases": [CASE, ...]}
//
//   Of every CASE
//     "name"       [a-z0-9-]+, at most 64, no two alike
//     "title"      a few words for the report
//     "asked"      one sentence: what the picture or the numbers must be
//     "hint"       one sentence: what to try after a failure; may be missing where there are no points
//     "tier"       "core" (default), "further", "challenge"
//     "points"     0..1000
//     "student"    true (default); false where the untouched skeleton may pass
//     "hidden"     true where the case is left out of what students get (cli/grader/release.cpp); false (default)
//     "rejects"    names of the mistakes that the case claims to catch; at least one where there are points
//     "functions"  names of the student's functions that the case exercises
//     "needs"      optional abilities of the driver; the case then has no points
//     "settings"   {"shadow.resolution": 2048, ...}: what differs from the program's defaults
//
//   Of a picture
//     "scene"      a built-in scene's name or a file
//     "camera"     {"eye": [x,y,z], "target", "up", "fov_y_degrees", "near", "far"}; what is absent is the scene's
//     "size"       [width, height] pixels, 1..4096; [256, 256]
//     "output"     "colour" (default) or an intermediate that the program lists
//     "profile"    "strict" (default), "robust", "exact"
//     "unit"       "colour" (default), "encoded", "degrees", "number"; see Unit
//     "delta"      how far a pixel may be off, in the unit: 3 for colours (default); required for degrees and numbers
//     "budget"     pixels that may be over delta: 4
//     "exposure"   factor before clamping, colour only: 1
//     "mask"       [[x, y, width, height], ...]: what is not compared, at most a quarter of the picture
//     "regions"    [{"name", "at": [x, y, width, height], "weight"}, ...]: what counts more or less for partial credit
//     "reason"     why delta, budget and mask are what they are; required where they are not the default
//     "truth_differs"  why the reference is not the ground truth that the program's --truth traces; for the project's
//                  own tests (tests/steps/truth.cpp), the judge does nothing with it
//     "choice"     makes it a budget case (judge/compare/choice.hpp): the student chooses settings in choices.txt, and
//     earns by
//                  the error against the truth: {"settings": [names], "at_most": {count: most}, "error": "rmse",
//                  "flip", "misclassified", "distance", "degrees" or "wrong", "full": error, "none": error}; needs a
//                  reason
//     "references" accepted pictures beside the case file: ["NAME.exr"]
//
//   Of a probe
//     "probe"      the function, as the program lists it
//     "inputs"     [{"eye": [x,y,z], "count": 3, ...}, ...]; a matrix is its columns one after another
//     "expected"   [[numbers of input 0], ...]; non-finite ones as "nan", "inf", "-inf"; or
//     "expected_from": "reference"   they stand in NAME.values.json, written by the reference command
//     "tolerance"  {"absolute", "relative", "ulp", "reason"}; without it numbers must be equal
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "judge/compare/choice.hpp"
#include "judge/compare/regions.hpp"

namespace atelier::judge {

/// How two pictures or lists of numbers are compared (see handouts/README or CONTRIBUTING: "Profiles").
enum class Profile {
  strict,  ///< pixels over delta are few and form no solid blob, and the picture is not shifted
  robust,  ///< pixels outside the reference's 3x3 neighbourhood range form no solid blob
  exact,   ///< equal bit by bit
  values,  ///< numbers of a probe, each within its tolerance
};

/// In what unit a picture's pixels differ.
enum class Unit {
  colour,   ///< linear colour: clamped to 0..1 after `exposure`, sRGB-encoded, differences in 1/255
  encoded,  ///< colour that is encoded already: clamped, differences in 1/255
  degrees,  ///< rgb is a direction n/2 + 1/2; the angle between the two
  number,   ///< data: absolute difference per channel, in the data's own unit
};

struct Tolerance {
  double absolute = 0, relative = 0;  ///< |yours - expected| <= absolute + relative |expected|
  int ulp = 0;                        ///< or at most so many 32-bit floats apart
  std::string reason;                 ///< why this large and no smaller; required unless all three are 0
};

/// What may follow from a case.
struct JudgedCase {
  Case ask;
  std::string title, asked, hint;
  double points = 0;
  std::string tier = "core";           ///< core, further, challenge
  bool student = true;                 ///< false: the untouched skeleton may pass (a background, a given part)
  bool hidden = false;                 ///< judged wherever it is, and left out of releases
  std::vector<std::string> rejects;    ///< the mistakes that this case claims to catch
  std::vector<std::string> functions;  ///< what the student wrote that this case exercises
  std::vector<std::string> needs;  ///< optional abilities of the driver ("clip_control"); the case then has no points

  // Of a picture
  Profile profile = Profile::strict;
  Unit unit = Unit::colour;
  double delta = 3;              ///< in the unit: 1/255, degrees, or the data's own
  int budget = 4;                ///< pixels that may be over delta
  double exposure = 1;           ///< factor before clamping, colour only
  std::vector<Rectangle> mask;   ///< what is not compared; a NaN or an infinity there fails all the same
  std::vector<Region> regions;   ///< what counts more or less for partial credit
  std::optional<Choice> choice;  ///< a budget case: compared with the truth by error and cost, not by profile
  std::string reason;         ///< why delta, budget and mask are what they are; required where they are not the default
  std::string truth_differs;  ///< why the reference is not what --truth traces; empty where it is
  std::vector<std::filesystem::path> references;  ///< accepted pictures, in the folder of references

  // Of a probe
  std::vector<Numbers> expected;        ///< one list an input; empty where they stand in expected_file
  std::filesystem::path expected_file;  ///< NAME.values.json among the references, or empty
  Tolerance tolerance;
};

/// All cases of a step.
struct CaseFile {
  std::filesystem::path path;
  std::string step;  ///< "01-transforms"
  std::string title;
  std::vector<JudgedCase> cases;
};

/// Where the references of a case file's cases are: references/ beside it.
std::filesystem::path references_folder(const std::filesystem::path& case_file);

/// Reads and checks tests/cases/NN-name/cases.json. Throws Error naming the file, the case, the field, the value and
/// what is allowed. Does not read the references.
CaseFile read_case_file(const std::filesystem::path& path);

}  // namespace atelier::judge
