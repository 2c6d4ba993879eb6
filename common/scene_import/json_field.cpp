#include "scene_import/json_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.hpp"

namespace atelier::scene_import {

std::optional<JsonField> JsonField::find(const char* key) const {
  if (!value_->is_object()) fail(fmt::format("found: {}, needed: an object", value_->type_name()));
  const auto member = value_->find(key);
  if (member == value_->end()) return {};
  return JsonField(*member, *file_, path_.empty() ? key : path_ + "." + key);
}

JsonField JsonField::at(const char* key) const {
  if (auto member = find(key)) return *member;
  fail(fmt::format("'{}' is missing", key));
}

JsonField JsonField::operator[](std::size_t index) const {
  if (index >= size()) fail(fmt::format("element {} of {}", index, size()));
  return JsonField((*value_)[index], *file_, fmt::format("{}[{}]", path_, index));
}

std::size_t JsonField::size() const {
  if (!value_->is_array()) fail(fmt::format("found: {}, needed: an array", value_->type_name()));
  return value_->size();
}

double JsonField::number() const {
  if (!value_->is_number()) fail(fmt::format("found: {}, needed: a number", value_->type_name()));
  const double number = value_->get<double>();
  if (!std::isfinite(number)) fail("the number is not finite");
  return number;
}

std::int64_t JsonField::integer(std::int64_t low, std::int64_t high) const {
  const double value = number();
  // Limits are far below 2^53, up to which doubles hold every integer.
  if (value != std::floor(value) || value < double(low) || value > double(high))
    fail(fmt::format("{} (allowed: {}..{})", value, low, high));
  return std::int64_t(value);
}

int JsonField::index(std::size_t count) const {
  const double value = number();
  if (value != std::floor(value) || value < 0 || value >= double(count))
    fail(fmt::format("index {} of {}", value, count));
  return int(value);
}

const std::string& JsonField::text() const {
  if (!value_->is_string()) fail(fmt::format("found: {}, needed: a text", value_->type_name()));
  return value_->get_ref<const std::string&>();
}

bool JsonField::flag() const {
  if (!value_->is_boolean()) fail(fmt::format("found: {}, needed: true or false", value_->type_name()));
  return value_->get<bool>();
}

std::vector<double> JsonField::numbers(std::size_t count) const {
  if (size() != count) fail(fmt::format("{} elements (allowed: {})", size(), count));
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back((*this)[i].number());
  return values;
}

double JsonField::number_or(const char* key, double fallback) const {
  const auto member = find(key);
  return member ? member->number() : fallback;
}

std::int64_t JsonField::integer_or(const char* key, std::int64_t low, std::int64_t high, std::int64_t fallback) const {
  const auto member = find(key);
  return member ? member->integer(low, high) : fallback;
}

bool JsonField::flag_or(const char* key, bool fallback) const {
  const auto member = find(key);
  return member ? member->flag() : fallback;
}

std::string JsonField::text_or(const char* key, const std::string& fallback) const {
  const auto member = find(key);
  return member ? member->text() : fallback;
}

std::vector<double> JsonField::numbers_or(const char* key, const std::vector<double>& fallback) const {
  const auto member = find(key);
  return member ? member->numbers(fallback.size()) : fallback;
}

std::optional<int> JsonField::index_or_none(const char* key, std::size_t count) const {
  const auto member = find(key);
  if (!member) return {};
  return member->index(count);
}

std::size_t JsonField::size_or_zero(const char* key) const {
  const auto member = find(key);
  return member ? member->size() : 0;
}

void JsonField::fail(const std::string& complaint) const {
  throw Error(path_.empty() ? fmt::format("{}: {}", *file_, complaint)
                            : fmt::format("{}: {}: {}", *file_, path_, complaint));
}

namespace {

/// The nesting depth of brackets outside strings, which limits recursion. (A callback of the library's parser could
/// report it, but takes time quadratic in the number of siblings.)
int nesting(std::string_view text) {
  int depth = 0, deepest = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string && c == '\\')
      ++i;
    else if (c == '"')
      in_string = !in_string;
    else if (!in_string && (c == '[' || c == '{'))
      deepest = std::max(deepest, ++depth);
    else if (!in_string && (c == ']' || c == '}'))
      --depth;
  }
  return deepest;
}

}  // namespace

nlohmann::json parse_json(std::string_view text, const std::string& file) {
  constexpr int deepest = 64;
  if (nesting(text) > deepest) throw Error(fmt::format("{}: JSON nested deeper than {}", file, deepest));
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    throw Error(fmt::format("{}: not valid JSON (at byte {})", file, error.byte));
  } catch (const nlohmann::json::exception&) {
    throw Error(fmt::format("{}: not valid JSON (a number is out of range)", file));
  }
}

}  // namespace atelier::scene_import
