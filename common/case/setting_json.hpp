// Settings as JSON: in case files, plans of measurement and lists.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "case/settings.hpp"

namespace atelier {

/// true, a number, the name of a choice, or a colour as [red, green, blue] of linear light or "#rrggbb" in sRGB codes;
/// of one line, at most 64 bytes. Which of them a setting takes, it says itself (Settings::set). Throws Error with
/// `where`, the value and what is allowed.
SettingValue setting_from_json(const nlohmann::json& value, const std::string& where);

/// An object of such values by the settings' names, which consist of a-z 0-9 . _ and -.
std::map<std::string, SettingValue> settings_from_json(const nlohmann::json& object, const std::string& where);

/// What setting_from_json reads back as the same value.
nlohmann::json setting_to_json(const SettingValue& value);

}  // namespace atelier
