#include "grade/course/toml_value.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <chrono>
#include <sstream>
#include <utility>

#include "base/error.hpp"
#include "base/printable.hpp"

namespace atelier::grade {
namespace {

std::optional<std::int64_t> moment_of(const toml::date_time& date) {
  if (!date.offset) return std::nullopt;
  const std::chrono::sys_days day = std::chrono::year(date.date.year) / date.date.month / date.date.day;
  const std::int64_t seconds = (date.time.hour * 60 + date.time.minute) * 60 + date.time.second;
  return std::chrono::sys_seconds(day).time_since_epoch().count() + seconds - date.offset->minutes * 60;
}

template <class Value>
std::string in_toml(const Value& value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

TomlValue plain(const toml::node& node);

/// Tables of the library are sorted by key; the file's order is that of the keys' places.
std::vector<TomlValue> members_of(const toml::table& table) {
  using Place = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<std::pair<Place, TomlValue>> placed;
  for (const auto& [key, node] : table) {
    const toml::source_position& begin = key.source().begin;
    TomlValue member = plain(node);
    member.key = std::string(key.str());
    member.line = int(begin.line);
    placed.emplace_back(Place(begin.line, begin.column), std::move(member));
  }
  std::stable_sort(placed.begin(), placed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<TomlValue> members;
  for (auto& [place, member] : placed) members.push_back(std::move(member));
  return members;
}

TomlValue plain(const toml::node& node) {
  using Kind = TomlValue::Kind;
  TomlValue value;
  value.line = int(node.source().begin.line);
  node.visit([&](const auto& known) {
    using Node = std::remove_cvref_t<decltype(known)>;
    if constexpr (toml::is_table<Node>) {
      value.elements = members_of(known);
      value.text = "a table";
    } else if constexpr (toml::is_array<Node>) {
      value.kind = Kind::list;
      value.text = "a list";
      for (const toml::node& element : known) value.elements.push_back(plain(element));
    } else if constexpr (toml::is_string<Node>) {
      value.kind = Kind::text;
      value.text = known.get();
    } else {
      value.text = in_toml(known.get());
      if constexpr (toml::is_boolean<Node> || toml::is_number<Node>) value.number = double(known.get());
      if constexpr (toml::is_date_time<Node>) value.moment = moment_of(known.get());
      value.kind = toml::is_boolean<Node>          ? Kind::boolean
                   : toml::is_integer<Node>        ? Kind::integer
                   : toml::is_floating_point<Node> ? Kind::number
                                                   : Kind::date;
    }
  });
  if (value.kind == Kind::boolean) value.text = value.number != 0 ? "true" : "false";
  return value;
}

}  // namespace

const TomlValue* TomlValue::find(std::string_view member) const {
  for (const TomlValue& element : elements)
    if (element.key == member) return &element;
  return nullptr;
}

TomlValue parse_toml(std::string_view text, const std::string& where) {
  try {
    return plain(toml::parse(text));
  } catch (const toml::parse_error& error) {
    throw Error(
        fmt::format("{}:{}: {}", where, error.source().begin.line, shorten(printable(error.description()), 200)));
  }
}

}  // namespace atelier::grade
