#include "judge/compare/sidecar.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/strict_json.hpp"

namespace atelier::judge {
namespace {

using strict_json::Json;

constexpr int schema = 1;
constexpr std::array profiles{std::pair{Profile::strict, "strict"}, std::pair{Profile::robust, "robust"},
                              std::pair{Profile::exact, "exact"}, std::pair{Profile::values, "values"}};
constexpr std::array units{std::pair{Unit::colour, "colour"}, std::pair{Unit::encoded, "encoded"},
                           std::pair{Unit::degrees, "degrees"}, std::pair{Unit::number, "number"}};

template <class Words>
std::vector<std::string> words_of(const Words& words) {
  std::vector<std::string> list;
  for (const auto& [value, word] : words) list.emplace_back(word);
  return list;
}

template <class Words, class Value>
std::string word_of(const Words& words, Value value) {
  for (const auto& [known, word] : words)
    if (known == value) return word;
  return "unknown";
}

template <class Words>
auto value_of(const Words& words, const Json& text, const std::string& where) {
  const std::string chosen = strict_json::one_of(text, where, words_of(words));
  for (const auto& [value, word] : words)
    if (chosen == word) return value;
  throw Error(where + ": unknown word");
}

std::vector<Numbers> read_results(const Json& list, const std::string& where) {
  if (!list.is_array()) strict_json::refuse(list, where, "a list of lists of numbers, one an input");
  std::vector<Numbers> results;
  for (const Json& entry : list)
    results.push_back(entry.empty() ? Numbers{}
                                    : strict_json::numbers(entry, fmt::format("{}[{}]", where, results.size())));
  return results;
}

Json write_results(const std::vector<Numbers>& results) {
  Json list = Json::array();
  for (const Numbers& numbers : results) list.push_back(strict_json::from_numbers(numbers));
  return list;
}

}  // namespace

std::string to_string(Profile profile) {
  return word_of(profiles, profile);
}
std::string to_string(Unit unit) {
  return word_of(units, unit);
}

Sidecar read_sidecar(const std::filesystem::path& file) {
  const std::string where = file.string();
  const Json json = strict_json::parse(read_file(file), where);
  strict_json::refuse_unknown(
      json,
      {"schema", "case", "profile", "unit", "delta", "budget", "exposure", "mask", "regions", "reason", "sha256",
       "environment", "skeleton_share", "nearest", "margin", "results", "needs", "atlas"},
      where);
  const auto member = [&](const char* name) -> const Json& { return strict_json::required(json, name, where); };
  const auto at = [&](const char* name) { return where + ": " + name; };
  strict_json::integer(member("schema"), at("schema"), schema, schema);

  Sidecar sidecar;
  sidecar.case_name = strict_json::name(member("case"), at("case"));
  sidecar.profile = value_of(profiles, member("profile"), at("profile"));
  sidecar.skeleton_fraction = strict_json::number(member("skeleton_share"), at("skeleton_share"), 0, 1);
  sidecar.margin = strict_json::number(member("margin"), at("margin"), 0, 1e9);
  if (const Json* nearest = strict_json::optional(json, "nearest"))
    sidecar.nearest = strict_json::name(*nearest, at("nearest"));
  if (const Json* needs = strict_json::optional(json, "needs")) {
    if (!needs->is_array()) strict_json::refuse(*needs, at("needs"), "a list of names of functions");
    for (const Json& name : *needs) sidecar.needs.push_back(strict_json::text(name, at("needs"), 64));
  }
  const Json& environment = member("environment");
  if (!environment.is_object()) strict_json::refuse(environment, at("environment"), "an object of texts");
  for (const auto& [name, text] : environment.items())
    sidecar.environment[name] = strict_json::text(text, at("environment") + ": " + name);

  if (sidecar.profile == Profile::values) {
    if (const Json* results = strict_json::optional(json, "results"))
      sidecar.values = read_results(*results, at("results"));
    return sidecar;
  }
  sidecar.unit = value_of(units, member("unit"), at("unit"));
  sidecar.delta = strict_json::number(member("delta"), at("delta"), 0, 1e9);
  sidecar.budget = strict_json::integer(member("budget"), at("budget"), 0, 1 << 24);
  sidecar.exposure = strict_json::number(member("exposure"), at("exposure"), 0, 1e9);
  constexpr glm::ivec2 any_size(4096);  // the largest allowed; the case file's own size was checked when it was read
  if (const Json* mask = strict_json::optional(json, "mask")) sidecar.mask = read_mask(*mask, at("mask"), any_size);
  if (const Json* regions = strict_json::optional(json, "regions"))
    sidecar.regions = read_regions(*regions, at("regions"), any_size);
  sidecar.sha256 = strict_json::name(member("sha256"), at("sha256"), "");
  if (const Json* reason = strict_json::optional(json, "reason"))
    sidecar.reason = strict_json::text(*reason, at("reason"));
  if (const Json* atlas = strict_json::optional(json, "atlas")) {
    if (!atlas->is_array()) strict_json::refuse(*atlas, at("atlas"), "a list of names of mistakes");
    for (const Json& name : *atlas) sidecar.atlas.push_back(strict_json::name(name, at("atlas")));
  }
  return sidecar;
}

void write_sidecar(const std::filesystem::path& file, const Sidecar& sidecar) {
  nlohmann::ordered_json json;
  json["schema"] = schema;
  json["case"] = sidecar.case_name;
  json["profile"] = to_string(sidecar.profile);
  if (sidecar.profile != Profile::values) {
    json["unit"] = to_string(sidecar.unit);
    json["delta"] = sidecar.delta;
    json["budget"] = sidecar.budget;
    json["exposure"] = sidecar.exposure;
    if (!sidecar.mask.empty()) json["mask"] = to_json(sidecar.mask);
    if (!sidecar.regions.empty()) json["regions"] = to_json(sidecar.regions);
    if (!sidecar.reason.empty()) json["reason"] = sidecar.reason;
    json["sha256"] = sidecar.sha256;
  }
  json["skeleton_share"] = sidecar.skeleton_fraction;
  json["margin"] = sidecar.margin;
  if (sidecar.nearest) json["nearest"] = *sidecar.nearest;
  json["environment"] = sidecar.environment;
  if (!sidecar.needs.empty()) json["needs"] = sidecar.needs;
  if (!sidecar.atlas.empty()) json["atlas"] = sidecar.atlas;
  if (!sidecar.values.empty()) json["results"] = write_results(sidecar.values);
  write_file(file, json.dump(2) + "\n");
}

void check_sidecar(const Sidecar& sidecar, const JudgedCase& c, const std::filesystem::path& file) {
  const auto expect = [&](const char* what, const auto& made, const auto& now) {
    if (made != now)
      throw Error(
          fmt::format("{}: was made for {} {}, but case '{}' now has {}; make the reference again with "
                      "'./atelier reference', which checks the mistakes against the new tolerance",
                      file.string(), what, made, c.ask.name, now));
  };
  expect("the case", sidecar.case_name, c.ask.name);
  expect("profile", to_string(sidecar.profile), to_string(c.profile));
  if (c.profile == Profile::values) return;
  expect("unit", to_string(sidecar.unit), to_string(c.unit));
  expect("delta", sidecar.delta, c.delta);
  expect("budget", sidecar.budget, c.budget);
  expect("exposure", sidecar.exposure, c.exposure);
  expect("mask", to_json(sidecar.mask).dump(), to_json(c.mask).dump());
  expect("regions", to_json(sidecar.regions).dump(), to_json(c.regions).dump());
}

WrongValues read_wrong_values(const std::filesystem::path& file) {
  const std::string where = file.string();
  const Json json = strict_json::parse(read_file(file), where);
  strict_json::refuse_unknown(json, {"schema", "mistakes", "unwritten"}, where);
  strict_json::integer(strict_json::required(json, "schema", where), where + ": schema", schema, schema);
  const Json& mistakes = strict_json::required(json, "mistakes", where);
  if (!mistakes.is_object()) strict_json::refuse(mistakes, where + ": mistakes", "an object of lists by mistake");
  WrongValues values;
  for (const auto& [name, results] : mistakes.items())
    values.mistakes[name] = read_results(results, where + ": mistakes: " + name);
  if (const Json* unwritten = strict_json::optional(json, "unwritten")) {
    if (!unwritten->is_array()) strict_json::refuse(*unwritten, where + ": unwritten", "a list of lists of results");
    for (const Json& results : *unwritten) values.unwritten.push_back(read_results(results, where + ": unwritten"));
  }
  return values;
}

void write_wrong_values(const std::filesystem::path& file, const WrongValues& values) {
  nlohmann::ordered_json json;
  json["schema"] = schema;
  json["mistakes"] = nlohmann::ordered_json::object();
  for (const auto& [name, results] : values.mistakes) json["mistakes"][name] = write_results(results);
  for (const std::vector<Numbers>& results : values.unwritten) json["unwritten"].emplace_back(write_results(results));
  write_file(file, json.dump(1) + "\n");
}

std::filesystem::path sidecar_path(const std::filesystem::path& picture) {
  return std::filesystem::path(picture).replace_extension(".json");
}
std::filesystem::path values_path(const std::filesystem::path& folder, const std::string& case_name) {
  return folder / (case_name + ".values.json");
}
std::filesystem::path atlas_path(const std::filesystem::path& folder, const std::string& case_name) {
  return folder / (case_name + ".atlas.png");
}
std::filesystem::path wrong_values_path(const std::filesystem::path& folder, const std::string& case_name) {
  return folder / (case_name + ".mistakes.json");
}

}  // namespace atelier::judge
