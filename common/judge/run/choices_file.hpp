// choices.txt: the settings that a student chooses for budget cases.
//
//   // a line that begins with two slashes, or with #, is a comment
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

inline constexpr const char* choices_file = "choices.txt";  ///< in NN-name/, if the step has budget cases

/// Values by case and setting.
using Choices = std::map<std::string, std::map<std::string, SettingValue>>;

/// Throws Error naming `where`, the line, its text and what is allowed, and if a setting is chosen twice for one case.
Choices read_choices(std::string_view text, const std::string& where);

/// The case for the program, with the choices for it filled in. Throws Error if a chosen setting is not one of the
/// case's choices, or if a name in `choices` is not a budget case of the step.
Case with_choices(const JudgedCase& c, const Choices& choices);

}  // namespace atelier::judge
