// choices.txt: the settings that a student chooses for budget cases.
//
//   // what follows two slashes at the beginning of a line is passed over
//   hall-choice: hall.segments = 24
//   shine-choice: specular.power = stable
//
// A value has no spaces; a colour is three numbers of linear light ("0.2,0.5,1") or sRGB codes ("#3380ff").
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "case/settings.hpp"
#include "judge/compare/judged_case.hpp"

namespace atelier::judge {

inline constexpr const char* choices_file = "choices.txt";  ///< below NN-name/, where the step has budget cases

/// By case, by setting.
using Choices = std::map<std::string, std::map<std::string, SettingValue>>;

/// Throws Error naming the line of `where`, what stands there and what is allowed. A setting that is chosen twice for
/// one case is refused.
Choices read_choices(std::string_view text, const std::string& where);

/// What the program is to be asked, with what was chosen for this case. Throws Error where a setting was chosen that
/// the case does not leave open, and where something was chosen for a name that is no budget case of the step.
Case with_choices(const JudgedCase& c, const Choices& choices);

}  // namespace atelier::judge
