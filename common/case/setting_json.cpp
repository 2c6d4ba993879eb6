#include "case/setting_json.hpp"

#include <limits>

#include "case/strict_json.hpp"

namespace atelier {
using strict_json::Json;

SettingValue setting_from_json(const Json& value, const std::string& where) {
  using Whole = std::numeric_limits<int>;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number_integer()) return strict_json::whole(value, where, Whole::min(), Whole::max());
  if (value.is_number()) return strict_json::number(value, where, -infinity, infinity);
  if (value.is_string()) return strict_json::text(value, where, 64);
  strict_json::refuse(value, where, "true, false, a number or the name of a choice");
}

std::map<std::string, SettingValue> settings_from_json(const Json& object, const std::string& where) {
  if (!object.is_object()) strict_json::refuse(object, where, "an object {...} of settings");
  std::map<std::string, SettingValue> settings;
  for (const auto& [name, value] : object.items()) {
    strict_json::name(name, where, "._-");
    settings[name] = setting_from_json(value, where + ": " + name);
  }
  return settings;
}

Json setting_to_json(const SettingValue& value) {
  return std::visit([](const auto& v) { return Json(v); }, value);
}

}  // namespace atelier
