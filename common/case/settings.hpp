// The typed settings of a step: every choice between speed and accuracy, set by a scene, a case or the command line.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "case/colour_text.hpp"

namespace atelier {

using SettingValue = std::variant<bool, int, double, std::string, Colour>;  ///< string: the name of a choice

/// One setting that a step program offers.
struct SettingSpec {
  std::string name;                  ///< "shadow.resolution": group, dot, name
  SettingValue fallback;             ///< the default; its type is the setting's type
  double low = 0, high = 0;          ///< closed range of an int, a real, or each component of a colour
  std::vector<std::string> choices;  ///< the names, if the setting is a choice
  std::string help;                  ///< one sentence with the unit: "depth texels along a side"
};

/// "2048", "off", "slope", "0.2,0.5,1": the text from which Settings::set reads the same value.
std::string setting_text(const SettingValue& value);

/// The allowed values in words: "on, off", "32..8192", "none, constant, slope" or "R,G,B in linear light, each 0..1, or
/// sRGB codes #rrggbb".
std::string allowed_values(const SettingSpec& spec);

/// The values for a list of specs. They start at their defaults and are always within their ranges.
class Settings {
 public:
  Settings() = default;
  /// Throws Error if a name is declared twice or a default is outside its range or choices.
  explicit Settings(std::vector<SettingSpec> specs);

  /// Sets from text as on a command line ("2048", "off", "slope", "0.2,0.5,1", "#3380ff"). Throws Error naming the
  /// setting, the value and what is allowed; for an unknown name it suggests the nearest known one.
  void set(std::string_view name, std::string_view text);
  void set(std::string_view name, const char* text) { set(name, std::string_view(text)); }
  void set(std::string_view name, const std::string& text) { set(name, std::string_view(text)); }
  /// Sets from a typed value, as in a case file. An int converts to a real, and to a choice with the same text ("16");
  /// nothing else converts.

  void set(std::string_view name, const SettingValue& value);

  /// Each throws Error for an unknown name and for a setting of another type.
  bool flag(std::string_view name) const;
  int integer(std::string_view name) const;
  double real(std::string_view name) const;
  const std::string& choice(std::string_view name) const;
  Colour colour(std::string_view name) const;

  const std::vector<SettingSpec>& specs() const { return specs_; }
  const std::map<std::string, SettingValue, std::less<>>& values() const { return values_; }
  const SettingValue& value(std::string_view name) const;
  bool has(std::string_view name) const;  ///< whether there is a setting of this name

 private:
  const SettingSpec& spec(std::string_view name) const;
  std::vector<SettingSpec> specs_;
  std::map<std::string, SettingValue, std::less<>> values_;
};

}  // namespace atelier
