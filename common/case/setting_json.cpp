#include "case/setting_json.hpp"

#include <limits>

#include "base/strict_json.hpp"

namespace atelier {
namespace {

using strict_json::Json;

Colour colour_from_json(const Json& value, const std::string& where) {
  if (value.is_array()) {
    const std::vector<double> light = strict_json::vector(value, where, 3);
    return {light[0], light[1], light[2]};
  }
  const std::optional<Colour> colour = parse_colour(value.get_ref<const std::string&>());
  if (!colour) strict_json::refuse(value, where, "a colour as \"#rrggbb\", six hexadecimal digits");
  return *colour;
}

template <class Plain>
Json json_of(const Plain& value) {
  return value;
}
Json json_of(const Colour& colour) {
  return {colour.r, colour.g, colour.b};
}

}  // namespace

SettingValue setting_from_json(const Json& value, const std::string& where) {
  using Whole = std::numeric_limits<int>;
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number_integer()) return strict_json::integer(value, where, Whole::min(), Whole::max());
  if (value.is_number()) return strict_json::number(value, where, -unlimited, unlimited);
  const bool codes = value.is_string() && value.get_ref<const std::string&>().starts_with('#');
  if (value.is_array() || codes) return colour_from_json(value, where);
  if (value.is_string()) return strict_json::text(value, where, 64);
  strict_json::refuse(value, where, "true, false, a number, the name of a choice, [red, green, blue] or \"#rrggbb\"");
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
  return std::visit([](const auto& v) { return json_of(v); }, value);
}

}  // namespace atelier
