#include "judge/compare/judged_case.hpp"

#include <fmt/format.h>

#include <limits>
#include <set>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "base/printable.hpp"
#include "base/strict_json.hpp"

namespace atelier::judge {
namespace {

using strict_json::Json;
namespace fs = std::filesystem;

constexpr std::size_t max_file = 16 << 20;  // bytes of a case file
constexpr double max_points = 1000;

/// One case object, and the location that its error messages begin with.
struct Reader {
  const Json& object;
  std::string where;

  const Json* find(const char* member) const { return strict_json::optional(object, member); }
  const Json& require(const char* member) const { return strict_json::required(object, member, where); }
  std::string at(const char* member) const { return where + ": " + member; }

  double number(const char* member, double fallback, double low, double high) const {
    const Json* value = find(member);
    return value ? strict_json::number(*value, at(member), low, high) : fallback;
  }
  std::string one_of(const char* member, const char* fallback, const std::vector<std::string>& choices) const {
    const Json* value = find(member);
    return value ? strict_json::one_of(*value, at(member), choices) : fallback;
  }
  std::vector<std::string> names(const char* member, std::string_view also) const {
    const Json* value = find(member);
    return value ? strict_json::names(*value, at(member), also) : std::vector<std::string>{};
  }
  [[noreturn]] void refuse(const std::string& sentence) const { throw Error(where + ": " + sentence); }
};

Profile profile_named(const std::string& name) {
  return name == "strict" ? Profile::strict : name == "robust" ? Profile::robust : Profile::exact;
}

Unit unit_named(const std::string& name) {
  if (name == "colour") return Unit::colour;
  if (name == "encoded") return Unit::encoded;
  return name == "degrees" ? Unit::degrees : Unit::number;
}

/// The largest possible difference of two pixels in a unit.
double largest_difference(Unit unit) {
  if (unit == Unit::degrees) return 180;
  return unit == Unit::number ? std::numeric_limits<float>::max() : 255;
}

void read_about(const Reader& r, JudgedCase& c) {
  c.title = strict_json::text(r.require("title"), r.at("title"), 120);
  c.asked = strict_json::text(r.require("asked"), r.at("asked"));
  c.points = strict_json::number(r.require("points"), r.at("points"), 0, max_points);
  c.tier = r.one_of("tier", "core", {"core", "further", "challenge"});
  if (const Json* student = r.find("student")) c.student = strict_json::boolean(*student, r.at("student"));
  if (const Json* hidden = r.find("hidden")) c.hidden = strict_json::boolean(*hidden, r.at("hidden"));
  c.rejects = r.names("rejects", "-");
  c.functions = r.names("functions", "_");
  if (const Json* together = r.find("together")) c.together = strict_json::boolean(*together, r.at("together"));
  c.needs = r.names("needs", "_-");
  if (c.points > 0 && !c.needs.empty()) {
    r.refuse(
        "a case that needs an optional driver feature must have 0 points, so that all machines have the same maximum");
  }
  if (c.points > 0 && c.rejects.empty())
    r.refuse("a case with points must name a mistake that it catches in 'rejects'");
  if (c.points > 0 || r.find("hint")) c.hint = strict_json::text(r.require("hint"), r.at("hint"));
}

std::vector<fs::path> read_references(const Reader& r, const std::string& name, const fs::path& folder) {
  const Json* list = r.find("references");
  if (!list) return {folder / (name + ".exr")};
  const std::string allowed = "a list of names of .exr or .png files in references/";
  if (!list->is_array() || list->empty()) strict_json::refuse(*list, r.at("references"), allowed);
  std::vector<fs::path> references;
  for (const Json& element : *list) {
    const fs::path file = strict_json::text(element, r.at("references"), 128);
    const bool picture = file.extension() == ".exr" || file.extension() == ".png";
    if (!picture || file.filename() != file) strict_json::refuse(element, r.at("references"), allowed);
    references.push_back(folder / file);
  }
  return references;
}

void read_picture(const Reader& r, const fs::path& folder, JudgedCase& c) {
  c.profile = profile_named(r.one_of("profile", "strict", {"strict", "robust", "exact"}));
  c.unit = unit_named(r.one_of("unit", "colour", {"colour", "encoded", "degrees", "number"}));
  const bool coloured = c.unit == Unit::colour || c.unit == Unit::encoded;
  if (c.profile == Profile::exact) {
    for (const char* member : {"delta", "budget"}) {
      if (r.find(member)) r.refuse(fmt::format("profile 'exact' allows no difference, so it takes no '{}'", member));
    }
    c.delta = 0, c.budget = 0;
  } else {
    const JudgedCase defaults;
    if (!coloured && !r.find("delta")) r.refuse("'delta' is missing: degrees and numbers have no default");
    c.delta = r.number("delta", defaults.delta, 0, largest_difference(c.unit));
    if (c.delta == 0) r.refuse("delta: 0 is not allowed; it takes a number above 0, or profile 'exact'");
    if (const Json* budget = r.find("budget")) {
      c.budget = strict_json::integer(*budget, r.at("budget"), 0, c.ask.size.x * c.ask.size.y);
    }
    const bool usual = coloured && c.delta == defaults.delta && c.budget == defaults.budget;
    if (!usual && !r.find("reason")) {
      r.refuse(fmt::format("'reason' is missing: delta {} and budget {} are not the defaults and need one", c.delta,
                           c.budget));
    }
  }
  if (const Json* mask = r.find("mask")) {
    c.mask = read_mask(*mask, r.at("mask"), c.ask.size);
    if (!r.find("reason")) r.refuse("'reason' is missing: a mask needs one");
  }
  if (const Json* regions = r.find("regions")) c.regions = read_regions(*regions, r.at("regions"), c.ask.size);
  if (const Json* choice = r.find("choice")) {
    c.choice = read_choice(*choice, r.at("choice"));
    if (!r.find("reason")) r.refuse("'reason' is missing: the limits of a choice need one");
  }
  if (const Json* reason = r.find("reason")) c.reason = strict_json::text(*reason, r.at("reason"));
  if (const Json* exposure = r.find("exposure")) {
    if (c.unit != Unit::colour) r.refuse("'exposure' is only allowed with unit 'colour'");
    c.exposure = strict_json::number(*exposure, r.at("exposure"), 1e-6, 1e6);
  }
  if (const Json* differs = r.find("truth_differs"))
    c.truth_differs = strict_json::text(*differs, r.at("truth_differs"));
  c.references = read_references(r, c.ask.name, folder);
}

Tolerance read_tolerance(const Reader& r) {
  const Json* object = r.find("tolerance");
  if (!object) return {};
  const Reader t{*object, r.at("tolerance")};
  strict_json::refuse_unknown(*object, {"absolute", "relative", "ulp", "reason"}, t.where);
  Tolerance tolerance;
  tolerance.absolute = t.number("absolute", 0, 0, std::numeric_limits<double>::infinity());
  tolerance.relative = t.number("relative", 0, 0, 1);
  if (const Json* ulp = t.find("ulp")) tolerance.ulp = strict_json::integer(*ulp, t.at("ulp"), 0, 1 << 20);
  const bool equal = tolerance.absolute == 0 && tolerance.relative == 0 && tolerance.ulp == 0;
  if (!equal || t.find("reason")) tolerance.reason = strict_json::text(t.require("reason"), t.at("reason"));
  return tolerance;
}

std::vector<NumberName> read_numbers(const Reader& r) {
  std::vector<NumberName> names;
  const Json* list = r.find("numbers");
  if (!list) return names;
  constexpr std::string_view mark = ": enum";
  if (!list->is_array() || list->empty()) strict_json::refuse(*list, r.at("numbers"), "a list of names");
  for (const Json& element : *list) {
    NumberName name{.name = strict_json::text(element, r.at("numbers"), 64)};
    name.is_enum = name.name.ends_with(mark);
    if (name.is_enum) name.name.resize(name.name.size() - mark.size());
    names.push_back(std::move(name));
  }
  return names;
}

void read_probe(const Reader& r, const fs::path& folder, JudgedCase& c) {
  c.profile = Profile::values;
  c.numbers = read_numbers(r);
  c.tolerance = read_tolerance(r);
  if (const Json* from = r.find("expected_from")) {
    strict_json::one_of(*from, r.at("expected_from"), {"reference"});
    if (r.find("expected")) r.refuse("'expected' and 'expected_from' exclude each other");
    c.expected_file = folder / (c.ask.name + ".values.json");
    return;
  }
  const Json& lists = r.require("expected");
  if (!lists.is_array()) strict_json::refuse(lists, r.at("expected"), "a list of lists of numbers");
  for (const Json& list : lists) {
    c.expected.push_back(strict_json::numbers(list, fmt::format("{} {}", r.at("expected"), c.expected.size())));
  }
  for (const Numbers& result : c.expected)
    if (!c.numbers.empty() && result.size() != c.numbers.size())
      r.refuse(fmt::format("'numbers' has {} names for a result of {}", c.numbers.size(), result.size()));
  if (c.expected.size() != c.ask.inputs.size()) {
    r.refuse(fmt::format("'expected' has {} lists for {} inputs", c.expected.size(), c.ask.inputs.size()));
  }
}

void read_vary(const Reader& r, const Json& vary, JudgedCase& c) {
  if (c.choice) r.refuse("'vary' is not allowed with 'choice', whose truth is stored");
  if (!c.needs.empty()) r.refuse("'vary' is not allowed with 'needs': it would be judged on some machines only");
  c.vary = read_variation(vary, c.ask, r.at("vary"));
  const bool moves = !c.vary->camera.empty() || !c.vary->sizes.empty();
  if (moves && (!c.mask.empty() || !c.regions.empty()))
    r.refuse("vary: camera and size are not allowed with 'mask' or 'regions', whose rectangles would lie elsewhere");
}

JudgedCase read_case(const Json& object, const std::string& where, const fs::path& folder) {
  JudgedCase c;
  c.ask = parse_case(object, where);
  const Reader r{object, fmt::format("{}: case '{}'", where, c.ask.name)};
  read_about(r, c);
  c.ask.probe.empty() ? read_picture(r, folder, c) : read_probe(r, folder, c);
  if (const Json* vary = r.find("vary")) read_vary(r, *vary, c);
  return c;
}

/// A step's folder name: two digits, a hyphen, a name.
std::string read_step(const Json& value, const std::string& where) {
  const std::string step = strict_json::name(value, where);
  const bool numbered = step.size() > 3 && step.find_first_not_of("0123456789") == 2 && step[2] == '-';
  if (!numbered) strict_json::refuse(value, where, "a step's name, such as \"02-blinn-phong\"");
  return step;
}

}  // namespace

std::set<std::string> functions_of(const std::vector<JudgedCase>& cases) {
  std::set<std::string> functions;
  for (const JudgedCase& c : cases) functions.insert(c.functions.begin(), c.functions.end());
  return functions;
}

fs::path references_folder(const fs::path& case_file) {
  return case_file.parent_path() / "references";
}

CaseFile read_case_file(const fs::path& path) {
  const std::string where = printable(path.string());
  const Json document = strict_json::parse(read_file(path, max_file), where);
  CaseFile file{.path = path};
  const std::vector<Json> objects = case_objects(document, where);
  strict_json::required(document, "schema", where);  // case_objects has checked its value
  file.step = read_step(strict_json::required(document, "step", where), where + ": step");
  std::set<std::string> names;
  for (const Json& object : objects) {
    file.cases.push_back(read_case(object, where, references_folder(path)));
    const std::string& name = file.cases.back().ask.name;
    if (!names.insert(name).second) throw Error(fmt::format("{}: two cases are named '{}'", where, name));
  }
  for (const JudgedCase& c : file.cases)
    if (c.vary && names.contains(name_of_varied(c.ask.name)))
      throw Error(fmt::format("{}: case '{}': vary: '{}' is another case's name", where, c.ask.name,
                              name_of_varied(c.ask.name)));
  std::vector<std::string> budget_cases;
  for (const JudgedCase& c : file.cases)
    if (c.choice) budget_cases.push_back(c.ask.name);
  for (JudgedCase& c : file.cases)
    if (c.choice) c.choice->cases = budget_cases;
  return file;
}

}  // namespace atelier::judge
