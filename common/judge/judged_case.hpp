// A case as the judge knows it: what the program is asked, and what is thought of the answer.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"

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
  std::string reason;                 ///< why this large and no smaller; required
};

/// What may follow from a case.
struct JudgedCase {
  Case ask;
  std::string title, asked, hint;
  double points = 0;
  std::string tier = "core";          ///< core, further, challenge
  bool student = true;                ///< false: the untouched skeleton may pass (a background, a given part)
  std::vector<std::string> rejects;   ///< the mistakes that this case claims to catch
  std::vector<std::string> functions; ///< what the student wrote that this case exercises
  std::vector<std::string> needs;     ///< optional abilities of the driver ("clip_control"); the case then has no points

  // Of a picture
  Profile profile = Profile::strict;
  Unit unit = Unit::colour;
  double delta = 3;                   ///< in the unit: 1/255, degrees, or the data's own
  int budget = 4;                     ///< pixels that may be over delta
  double exposure = 1;                ///< factor before clamping, colour only
  std::string reason;                 ///< why delta and budget are what they are; required where they are not the default
  std::vector<std::filesystem::path> references;  ///< accepted pictures, beside the case file

  // Of a probe
  std::vector<Numbers> expected;      ///< one list an input
  Tolerance tolerance;
};

/// All cases of a step.
struct CaseFile {
  std::filesystem::path path;
  std::string step;                   ///< "01-transforms"
  std::string title;
  std::vector<JudgedCase> cases;
};

/// Reads and checks tests/cases/NN-name/cases.json. Throws Error naming the file, the case, the field, the value and what
/// is allowed. Does not read the references.
CaseFile read_case_file(const std::filesystem::path& path);

}  // namespace atelier::judge
