#include "judge/compare/variation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/error.hpp"
#include "base/sha256.hpp"
#include "base/strict_json.hpp"
#include "case/setting_json.hpp"

namespace atelier::judge {
namespace {

using strict_json::Json;

constexpr int max_count = 64;              // inputs
constexpr std::size_t max_name = 64;       // bytes of a case's name
constexpr double steps_of_range = 1000.0;  // at least, unless the numbers are whole
const std::string allowed_range = "[low, high], two numbers or two lists of the same length, low not above high";

// --- Reading ---

std::vector<Json> leaves(const Json& value) {
  if (!value.is_array()) return {value};
  std::vector<Json> all;
  for (const Json& element : value)
    for (Json& leaf : leaves(element)) all.push_back(std::move(leaf));
  return all;
}

bool is_whole(const Json& value) {
  return std::ranges::all_of(leaves(value), [](const Json& leaf) { return leaf.is_number_integer(); });
}

NumberRange read_range(const Json& value, const std::string& where) {
  if (!value.is_array() || value.size() != 2) strict_json::refuse(value, where, allowed_range);
  NumberRange range{strict_json::numbers(value[0], where), strict_json::numbers(value[1], where), is_whole(value)};
  const auto ordered = [](double low, double high) { return std::isfinite(low) && std::isfinite(high) && low <= high; };
  const bool same_length = range.low.size() == range.high.size();
  if (!same_length || !std::ranges::equal(range.low, range.high, ordered))
    strict_json::refuse(value, where, allowed_range);
  if (range.low == range.high) strict_json::refuse(value, where, "a range with something to draw, low below high");
  return range;
}

/// A range of one component fits everything.
void require_length(const NumberRange& range, std::size_t length, const Json& value, const std::string& where) {
  if (range.low.size() != 1 && range.low.size() != length)
    strict_json::refuse(value, where, fmt::format("a range of 1 or {} numbers", length));
}

std::map<std::string, NumberRange> read_camera(const Json& object, const std::string& where) {
  const std::vector<std::string> vectors = {"eye", "target", "up"}, numbers = {"fov_y_degrees", "near", "far"};
  std::vector<std::string> known = vectors;
  known.insert(known.end(), numbers.begin(), numbers.end());
  strict_json::refuse_unknown(object, known, where);
  std::map<std::string, NumberRange> camera;
  for (const auto& [name, value] : object.items()) {
    const std::string place = where + ": " + name;
    const NumberRange range = camera[name] = read_range(value, place);
    const std::size_t length = std::ranges::find(vectors, name) != vectors.end() ? 3 : 1;
    if (range.low.size() != length)
      strict_json::refuse(value, place, length == 3 ? "[[x, y, z], [x, y, z]]" : "[low, high]");
    if (name == "fov_y_degrees" && (range.low[0] <= 0 || range.high[0] > 179))
      strict_json::refuse(value, place, "degrees above 0 and up to 179");
  }
  return camera;
}

SettingRange read_setting(const Json& value, const std::string& where) {
  const std::string allowed = "[low, high] of numbers or colours, or a list of at least two choices";
  if (!value.is_array() || value.size() < 2) strict_json::refuse(value, where, allowed);
  SettingRange setting;
  for (const Json& choice : value) setting.choices.push_back(setting_from_json(choice, where));
  if (std::ranges::all_of(value, [](const Json& v) { return v.is_string() || v.is_boolean(); })) return setting;
  setting.choices.clear();
  setting.range = read_range(value, where);
  return setting;
}

std::map<std::string, SettingRange> read_settings(const Json& object, const std::string& where) {
  if (!object.is_object()) strict_json::refuse(object, where, "an object {...} of settings");
  std::map<std::string, SettingRange> settings;
  for (const auto& [name, value] : object.items()) {
    strict_json::name(name, where, "._-");
    settings[name] = read_setting(value, where + ": " + name);
  }
  return settings;
}

void read_of_picture(const Json& object, const std::string& where, Variation& variation) {
  if (const Json* camera = strict_json::optional(object, "camera"))
    variation.camera = read_camera(*camera, where + ": camera");
  const Json* sizes = strict_json::optional(object, "size");
  if (!sizes) return;
  const std::string place = where + ": size";
  if (!sizes->is_array() || sizes->empty()) strict_json::refuse(*sizes, place, "a list of sizes, [[256, 192], ...]");
  for (const Json& size : *sizes) variation.sizes.push_back(size_from_json(size, place));
}

void read_of_probe(const Json& object, const Case& ask, const std::string& where, Variation& variation) {
  const Json& count = strict_json::required(object, "count", where);
  variation.count = strict_json::integer(count, where + ": count", 1, max_count);
  variation.like = {0};
  if (const Json* like = strict_json::optional(object, "like")) {
    if (!like->is_array() || like->empty()) strict_json::refuse(*like, where + ": like", "a list of the case's inputs");
    variation.like.clear();
    for (const Json& index : *like)
      variation.like.push_back(
          std::size_t(strict_json::integer(index, where + ": like", 0, int(ask.inputs.size()) - 1)));
  }
  const Json& inputs = strict_json::required(object, "inputs", where);
  if (!inputs.is_object() || inputs.empty())
    strict_json::refuse(inputs, where + ": inputs", "an object with a range for at least one member of the inputs");
  for (const auto& [name, value] : inputs.items()) {
    const std::string place = where + ": inputs: " + name;
    variation.inputs[name] = read_range(value, place);
    for (const std::size_t index : variation.like) {
      const auto& values = ask.inputs[index].values;
      const auto found = values.find(name);
      if (found == values.end()) throw Error(fmt::format("{}: input {} has no such member", place, index));
      require_length(variation.inputs[name], found->second.size(), value, place);
    }
  }
  if (const Json* unit = strict_json::optional(object, "unit")) {
    variation.unit = strict_json::names(*unit, where + ": unit", "_[].");
    for (const std::string& name : variation.unit)
      if (!variation.inputs.contains(name)) throw Error(fmt::format("{}: unit: '{}' is not drawn", where, name));
  }
}

// --- Drawing ---

/// The generator of one case. Its results are the same everywhere, unlike those of the standard's distributions.
class Lots {
 public:
  Lots(std::uint64_t seed, const std::string& name)
      : random_(std::stoull(sha256(fmt::format("{} {}", seed, name)).substr(0, 16), nullptr, 16)) {}

  std::size_t below(std::size_t count) { return std::size_t(random_() % count); }

  double between(double low, double high, bool whole) {
    if (low == high) return low;
    int exponent = 0;
    std::frexp((high - low) / steps_of_range, &exponent);
    const double step = whole ? 1 : std::ldexp(1.0, exponent - 1);
    const double first = std::ceil(low / step), last = std::floor(high / step);
    return (first + double(random_() % (std::uint64_t(last - first) + 1))) * step;
  }

  Numbers from(const NumberRange& range, std::size_t length) {
    Numbers drawn;
    for (std::size_t i = 0; i < length; ++i) {
      const std::size_t k = range.low.size() == 1 ? 0 : i;
      drawn.push_back(between(range.low[k], range.high[k], range.whole));
    }
    return drawn;
  }

 private:
  std::mt19937_64 random_;
};

std::string in_words(const Numbers& numbers) {
  return numbers.size() == 1 ? fmt::format("{:.6g}", numbers[0]) : fmt::format("({:.6g})", fmt::join(numbers, ", "));
}

void set_camera(CaseCamera& camera, const std::string& member, const Numbers& drawn) {
  const auto vector = [&] { return glm::dvec3(drawn[0], drawn[1], drawn[2]); };
  if (member == "eye") camera.eye = vector();
  if (member == "target") camera.target = vector();
  if (member == "up") camera.up = vector();
  if (member == "fov_y_degrees") camera.fov_y_degrees = drawn[0];
  if (member == "near") camera.near = drawn[0];
  if (member == "far") camera.far = drawn[0];
}

SettingValue drawn_setting(const SettingRange& setting, Lots& lots) {
  if (!setting.choices.empty()) return setting.choices[lots.below(setting.choices.size())];
  const Numbers drawn = lots.from(setting.range, setting.range.low.size());
  if (drawn.size() == 3) return Colour{drawn[0], drawn[1], drawn[2]};
  return setting.range.whole ? SettingValue(int(drawn[0])) : SettingValue(drawn[0]);
}

void scale_to_unit(Numbers& vector) {
  double square = 0;
  for (const double x : vector) square += x * x;
  if (square == 0) vector.back() = square = 1;
  for (double& x : vector) x /= std::sqrt(square);
}

Arguments drawn_input(const Arguments& like, const Variation& variation, Lots& lots) {
  Arguments input = like;
  for (const auto& [name, range] : variation.inputs) {
    Numbers& values = input.values.at(name);
    values = lots.from(range, values.size());
    if (std::ranges::find(variation.unit, name) != variation.unit.end()) scale_to_unit(values);
  }
  return input;
}

}  // namespace

std::string name_of_varied(const std::string& name) {
  return name + "-varied";
}

Variation read_variation(const Json& object, const Case& ask, const std::string& where) {
  const bool is_probe = !ask.probe.empty();
  using Names = std::vector<std::string>;
  strict_json::refuse_unknown(
      object, is_probe ? Names{"count", "like", "inputs", "unit", "settings"} : Names{"camera", "settings", "size"},
      where);
  if (name_of_varied(ask.name).size() > max_name)
    throw Error(fmt::format("{}: the case's name must have at most {} characters, so that there is room for '{}'",
                            where, max_name - name_of_varied("").size(), name_of_varied("")));
  Variation variation;
  if (const Json* settings = strict_json::optional(object, "settings"))
    variation.settings = read_settings(*settings, where + ": settings");
  is_probe ? read_of_probe(object, ask, where, variation) : read_of_picture(object, where, variation);
  if (!is_probe && variation.camera.empty() && variation.settings.empty() && variation.sizes.empty())
    throw Error(where + ": there must be a range for something: camera, settings or size");
  return variation;
}

Varied vary(const Case& ask, const Variation& variation, std::uint64_t seed) {
  Lots lots(seed, ask.name);
  Varied varied{.ask = ask, .numbers = {}};
  varied.ask.name = name_of_varied(ask.name);
  std::vector<std::string> words;
  for (const auto& [member, range] : variation.camera) {
    const Numbers drawn = lots.from(range, range.low.size());
    set_camera(varied.ask.camera, member, drawn);
    words.push_back(fmt::format("camera.{} = {}", member, in_words(drawn)));
  }
  for (const auto& [name, setting] : variation.settings) {
    varied.ask.settings[name] = drawn_setting(setting, lots);
    words.push_back(fmt::format("{} = {}", name, setting_text(varied.ask.settings[name])));
  }
  if (!variation.sizes.empty()) {
    varied.ask.size = variation.sizes[lots.below(variation.sizes.size())];
    words.push_back(fmt::format("size = {}x{}", varied.ask.size.x, varied.ask.size.y));
  }
  if (variation.count > 0) {
    varied.ask.inputs.clear();
    for (int i = 0; i < variation.count; ++i)
      varied.ask.inputs.push_back(
          drawn_input(ask.inputs[variation.like[std::size_t(i) % variation.like.size()]], variation, lots));
    words.push_back(fmt::format("{} other inputs", variation.count));
  }
  varied.numbers = fmt::format("{}", fmt::join(words, ", "));
  return varied;
}

}  // namespace atelier::judge
