// Settings as JSON: in case files, measurement plans and lists.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "case/settings.hpp"

namespace atelier {

/// A bool, a number, the name of a choice (one line of at most 64 bytes), or a colour: linear [red, green, blue] or
/// sRGB codes "#rrggbb". Settings::set checks which of them a setting takes. Throws Error with `where`, the value and
/// what is allowed.
SettingValue setting_from_json(const nlohmann::json& value, const std::string& where);

/// An object of such values by setting name. Names consist of a-z 0-9 . _ and -.
std::map<std::string, SettingValue> settings_from_json(const nlohmann::json& object, const std::string& where);

/// JSON from which setting_from_json reads the same value.
nlohmann::json setting_to_json(const SettingValue& value);

}  // namespace atelier
