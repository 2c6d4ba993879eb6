#include "case/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/error.hpp"
#include "base/near_names.hpp"
#include "base/parse_number.hpp"
#include "base/printable.hpp"

namespace atelier {
namespace {

bool is_choice(const SettingSpec& spec) {
  return std::holds_alternative<std::string>(spec.fallback);
}

bool has_choice(const SettingSpec& spec, const std::string& name) {
  return std::find(spec.choices.begin(), spec.choices.end(), name) != spec.choices.end();
}

std::string type_name(const SettingValue& value) {
  static const char* const names[] = {"on or off", "a whole number", "a number", "a choice", "a colour"};
  return names[value.index()];
}

std::string shown(const SettingValue& value) {
  const std::string* words = std::get_if<std::string>(&value);
  return words ? "'" + shorten(printable(*words), 80) + "'" : setting_text(value);
}

[[noreturn]] void refuse(const SettingSpec& spec, const std::string& value) {
  throw Error(fmt::format("setting '{}': {} is not allowed; it takes {}", spec.name, value, allowed_values(spec)));
}

// Parsing a value of each type.

bool parse_value(std::string_view text, bool& flag) {
  flag = text == "on" || text == "true";
  return flag || text == "off" || text == "false";
}
bool parse_value(std::string_view text, int& number) {
  return parse_number(text, number);
}
bool parse_value(std::string_view text, double& number) {
  return parse_number(text, number);
}
bool parse_value(std::string_view text, std::string& choice) {
  choice = text;
  return true;
}
bool parse_value(std::string_view text, Colour& colour) {
  const std::optional<Colour> parsed = parse_colour(text);
  colour = parsed.value_or(colour);
  return parsed.has_value();
}

// Checking a value of each type.

bool is_allowed(const SettingSpec&, bool) {
  return true;
}
bool is_allowed(const SettingSpec& spec, double number) {
  return number >= spec.low && number <= spec.high;  // false for NaN
}
bool is_allowed(const SettingSpec& spec, int number) {
  return is_allowed(spec, double(number));
}
bool is_allowed(const SettingSpec& spec, const std::string& choice) {
  return has_choice(spec, choice);
}
bool is_allowed(const SettingSpec& spec, const Colour& colour) {
  return is_allowed(spec, colour.r) && is_allowed(spec, colour.g) && is_allowed(spec, colour.b);
}

/// `value`, converted to the type of `spec` and checked. An int converts to a real, and to a choice with the same text
/// ("16"), since the reader of a file cannot know the type; nothing else converts.
SettingValue checked(const SettingSpec& spec, SettingValue value) {
  if (std::holds_alternative<double>(spec.fallback) && std::holds_alternative<int>(value)) {
    value = double(std::get<int>(value));
  } else if (std::holds_alternative<int>(value) && has_choice(spec, setting_text(value))) {
    value = setting_text(value);
  }
  if (value.index() != spec.fallback.index()) refuse(spec, shown(value));
  if (!std::visit([&](const auto& v) { return is_allowed(spec, v); }, value)) refuse(spec, shown(value));
  return value;
}

}  // namespace

std::string setting_text(const SettingValue& value) {
  struct {
    std::string operator()(bool v) const { return v ? "on" : "off"; }
    std::string operator()(int v) const { return fmt::format("{}", v); }
    std::string operator()(double v) const { return fmt::format("{}", v); }  // the shortest text that reads back equal
    std::string operator()(const std::string& v) const { return v; }
    std::string operator()(const Colour& v) const { return colour_text(v); }
  } text;
  return std::visit(text, value);
}

std::string allowed_values(const SettingSpec& spec) {
  if (std::holds_alternative<bool>(spec.fallback)) return "on, off";
  if (is_choice(spec)) return join(spec.choices);
  if (std::holds_alternative<Colour>(spec.fallback))
    return fmt::format("R,G,B in linear light, each {}..{}, or sRGB codes #rrggbb", spec.low, spec.high);
  return fmt::format("{}..{}", spec.low, spec.high);
}

Settings::Settings(std::vector<SettingSpec> specs) : specs_(std::move(specs)) {
  for (const SettingSpec& spec : specs_) {
    if (!values_.emplace(spec.name, checked(spec, spec.fallback)).second) {
      throw Error(fmt::format("setting '{}' is declared twice", spec.name));
    }
  }
}

void Settings::set(std::string_view name, std::string_view text) {
  const SettingSpec& known = spec(name);
  SettingValue value = known.fallback;
  if (!std::visit([&](auto& v) { return parse_value(text, v); }, value)) refuse(known, shown(std::string(text)));
  values_.find(name)->second = checked(known, std::move(value));
}

void Settings::set(std::string_view name, const SettingValue& value) {
  const SettingSpec& known = spec(name);
  values_.find(name)->second = checked(known, value);
}

const SettingSpec& Settings::spec(std::string_view name) const {
  std::vector<std::string> known;
  for (const SettingSpec& spec : specs_) {
    if (spec.name == name) return spec;
    known.push_back(spec.name);
  }
  throw Error(fmt::format("unknown setting '{}'{}", shorten(printable(name), 80), suggestion(name, known)));
}

const SettingValue& Settings::value(std::string_view name) const {
  const auto found = values_.find(name);
  return found != values_.end() ? found->second : spec(name).fallback;  // spec() throws for an unknown name
}

bool Settings::has(std::string_view name) const {
  return std::any_of(specs_.begin(), specs_.end(), [&](const SettingSpec& spec) { return spec.name == name; });
}

namespace {

template <class Type>
const Type& typed(const SettingValue& value, std::string_view name) {
  if (const Type* asked = std::get_if<Type>(&value)) return *asked;
  throw Error(fmt::format("setting '{}' is {}, but was read as {}", name, type_name(value), type_name(Type{})));
}

}  // namespace

bool Settings::flag(std::string_view name) const {
  return typed<bool>(value(name), name);
}
int Settings::integer(std::string_view name) const {
  return typed<int>(value(name), name);
}
double Settings::real(std::string_view name) const {
  return typed<double>(value(name), name);
}
const std::string& Settings::choice(std::string_view name) const {
  return typed<std::string>(value(name), name);
}
Colour Settings::colour(std::string_view name) const {
  return typed<Colour>(value(name), name);
}

}  // namespace atelier
