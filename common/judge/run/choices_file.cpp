#include "judge/run/choices_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/near_names.hpp"
#include "base/parse_number.hpp"
#include "base/printable.hpp"
#include "base/trimmed.hpp"

namespace atelier::judge {
namespace {

/// A bool, an int, a real, a colour, or the name of a choice. The program checks later whether its setting takes it.
SettingValue value_of(std::string_view text) {
  if (text == "on" || text == "true") return true;
  if (text == "off" || text == "false") return false;
  int whole = 0;
  if (parse_number(text, whole)) return whole;
  double real = 0;
  if (parse_number(text, real) && std::isfinite(real)) return real;
  if (const std::optional<Colour> colour = parse_colour(text)) return *colour;
  return std::string(text);
}

constexpr std::string_view name_characters = "abcdefghijklmnopqrstuvwxyz0123456789-._";
constexpr std::string_view value_characters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-+._,#";

bool consists_of(std::string_view text, std::string_view allowed) {
  return !text.empty() && text.size() <= 64 && text.find_first_not_of(allowed) == text.npos;
}

}  // namespace

Choices read_choices(std::string_view text, const std::string& where) {
  Choices choices;
  int number = 0;
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // the byte-order mark that some editors write
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = trimmed(text.substr(begin, end - begin));
    begin = end + 1;
    ++number;
    if (line.empty() || line.starts_with("//") || line.starts_with("#")) continue;
    const auto colon = line.find(':'), equals = line.find('=', colon == line.npos ? 0 : colon);
    const std::string_view name = trimmed(line.substr(0, colon));
    const std::string_view setting =
        colon < equals && equals != line.npos ? trimmed(line.substr(colon + 1, equals - colon - 1)) : "";
    const std::string_view value = equals == line.npos ? "" : trimmed(line.substr(equals + 1));
    if (!consists_of(name, name_characters) || !consists_of(setting, name_characters) ||
        !consists_of(value, value_characters))
      throw Error(fmt::format("{}:{}: '{}' is not a choice; write CASE: SETTING = VALUE, the value without spaces",
                              where, number, shorten(printable(line), 80)));
    if (!choices[std::string(name)].emplace(setting, value_of(value)).second)
      throw Error(fmt::format("{}:{}: {} is chosen twice for {}", where, number, setting, name));
  }
  return choices;
}

Case with_choices(const JudgedCase& c, const Choices& choices) {
  const auto& known = c.choice->cases;
  for (const auto& [name, settings] : choices)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Error(fmt::format("{}: '{}' is not a case with a choice{}", choices_file, name, suggestion(name, known)));
  Case ask = c.ask;
  const auto chosen = choices.find(c.ask.name);
  if (chosen == choices.end()) return ask;
  for (const auto& [setting, value] : chosen->second) {
    const auto& open = c.choice->settings;
    if (std::find(open.begin(), open.end(), setting) == open.end())
      throw Error(fmt::format("{}: {}: {} cannot be chosen here, only {}", choices_file, c.ask.name, setting,
                              fmt::join(open, ", ")));
    ask.settings[setting] = value;
  }
  return ask;
}

}  // namespace atelier::judge
