#include "base/strict_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/error.hpp"
#include "base/near_names.hpp"
#include "base/printable.hpp"

namespace atelier::strict_json {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A value for an error message, shortened.
std::string shown(const Json& value) {
  if (value.is_structured() && value.size() > 16) return value.is_array() ? "a long list" : "a large object";
  return shorten(printable(value.dump(-1, ' ', false, Json::error_handler_t::replace)), 80);
}

/// The library's message without its exception code: "parse error at line 3, column 5: ...".
std::string reason(const std::exception& error) {
  std::string_view words = error.what();
  if (const std::size_t code_end = words.find("] "); words.starts_with('[') && code_end != words.npos) {
    words.remove_prefix(code_end + 2);
  }
  return shorten(printable(words), 200);
}

/// A parser callback that refuses what the library would accept: repeated members and deep nesting.
class Guard {
 public:
  explicit Guard(const std::string& where) : where_(where) {}

  bool operator()(int, Json::parse_event_t event, const Json& value) {
    using Event = Json::parse_event_t;
    if (event == Event::object_start || event == Event::array_start) {
      members_.emplace_back();
      if (members_.size() > max_depth) throw Error(fmt::format("{}: nested deeper than {} levels", where_, max_depth));
    } else if (event == Event::object_end || event == Event::array_end) {
      members_.pop_back();
    } else if (event == Event::key && !members_.back().insert(value.get<std::string>()).second) {
      throw Error(fmt::format("{}: member {} appears twice in one object", where_, shown(value)));
    }
    return true;
  }

 private:
  const std::string& where_;
  std::vector<std::set<std::string>> members_;  // of each enclosing object (empty for an array)
};

void flatten(const Json& value, const std::string& where, std::size_t limit, std::vector<double>& flat) {
  if (value.is_array()) {
    for (const Json& element : value) flatten(element, where, limit, flat);
    return;
  }
  if (flat.size() == limit) throw Error(fmt::format("{}: more than {} numbers", where, limit));
  flat.push_back(any_number(value, where));
}

}  // namespace

Json parse(std::string_view text, const std::string& where) {
  try {
    return Json::parse(text, Guard(where));
  } catch (const Json::exception& error) {
    throw Error(fmt::format("{}: {}", where, reason(error)));
  }
}

void refuse_unknown(const Json& object, const std::vector<std::string>& known, const std::string& where) {
  if (!object.is_object()) refuse(object, where, "an object {...}");
  for (const auto& [member, value] : object.items()) {
    if (std::find(known.begin(), known.end(), member) != known.end()) continue;
    throw Error(
        fmt::format("{}: unknown member '{}'{}", where, shorten(printable(member), 80), suggestion(member, known)));
  }
}

const Json& required(const Json& object, const char* name, const std::string& where) {
  if (const Json* value = optional(object, name)) return *value;
  throw Error(fmt::format("{}: member '{}' is missing", where, name));
}

const Json* optional(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

void refuse(const Json& value, const std::string& where, const std::string& allowed) {
  throw Error(fmt::format("{}: {} is not allowed; it takes {}", where, shown(value), allowed));
}

double number(const Json& value, const std::string& where, double low, double high) {
  const bool inside = value.is_number() && value.get<double>() >= low && value.get<double>() <= high;
  if (!inside || !std::isfinite(value.get<double>())) {
    const bool bounded = std::isfinite(low) || std::isfinite(high);
    refuse(value, where, bounded ? fmt::format("a number {}..{}", low, high) : "a finite number");
  }
  return value.get<double>();
}

int integer(const Json& value, const std::string& where, int low, int high) {
  // Compare as double: every JSON integer converts to one, and integers in the range of int do so exactly.
  const bool inside = value.is_number_integer() && value.get<double>() >= low && value.get<double>() <= high;
  if (!inside) refuse(value, where, fmt::format("a whole number {}..{}", low, high));
  return value.get<int>();
}

bool boolean(const Json& value, const std::string& where) {
  if (!value.is_boolean()) refuse(value, where, "true or false");
  return value.get<bool>();
}

std::string text(const Json& value, const std::string& where, std::size_t limit) {
  const std::string allowed = fmt::format("a text of one line, 1..{} bytes, without control characters", limit);
  if (!value.is_string()) refuse(value, where, allowed);
  const std::string& words = value.get_ref<const std::string&>();
  if (words.empty() || words.size() > limit || printable(words) != words) refuse(value, where, allowed);
  return words;
}

std::string one_of(const Json& value, const std::string& where, const std::vector<std::string>& choices) {
  const bool known = value.is_string() &&
                     std::find(choices.begin(), choices.end(), value.get_ref<const std::string&>()) != choices.end();
  if (!known) refuse(value, where, join(choices));
  return value.get<std::string>();
}

std::string name(const Json& value, const std::string& where, std::string_view also) {
  const auto allowed = [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || also.find(c) != also.npos;
  };
  const bool good = value.is_string() && [&](const std::string& word) {
    return !word.empty() && word.size() <= 64 && std::all_of(word.begin(), word.end(), allowed);
  }(value.get_ref<const std::string&>());
  if (!good) refuse(value, where, fmt::format("a name of 1..64 characters a-z 0-9 {}", also));
  return value.get<std::string>();
}

std::vector<std::string> names(const Json& value, const std::string& where, std::string_view also) {
  if (!value.is_array()) refuse(value, where, "a list of names");
  std::vector<std::string> list;
  for (const Json& element : value) {
    list.push_back(name(element, where, also));
    if (std::find(list.begin(), list.end() - 1, list.back()) != list.end() - 1) {
      throw Error(fmt::format("{}: '{}' appears twice", where, list.back()));
    }
  }
  return list;
}

double any_number(const Json& value, const std::string& where) {
  if (value.is_number()) return value.get<double>();
  if (value.is_boolean()) return value.get<bool>() ? 1 : 0;
  if (value == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (value == "inf") return infinity;
  if (value == "-inf") return -infinity;
  refuse(value, where, R"(a number, true, false, "nan", "inf" or "-inf")");
}

std::vector<double> numbers(const Json& value, const std::string& where, std::size_t limit) {
  std::vector<double> flat;
  flatten(value, where, limit, flat);
  if (flat.empty()) refuse(value, where, "at least one number");
  return flat;
}

std::vector<double> vector(const Json& value, const std::string& where, std::size_t count) {
  const std::string allowed = fmt::format("{} finite numbers [..., ...]", count);
  if (!value.is_array() || value.size() != count) refuse(value, where, allowed);
  std::vector<double> components;
  for (const Json& element : value) components.push_back(number(element, where, -infinity, infinity));
  return components;
}

Json from_number(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

Json from_numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (double value : values) list.push_back(from_number(value));
  return list;
}

}  // namespace atelier::strict_json
