#include "case/case.hpp"

#include <fmt/format.h>

#include <limits>
#include <set>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "base/printable.hpp"
#include "base/strict_json.hpp"
#include "case/setting_json.hpp"

namespace atelier {
namespace {

using strict_json::Json;

constexpr int max_size = 4096;              // pixels a side
constexpr std::size_t max_file = 16 << 20;  // bytes of a case file
constexpr std::size_t max_inputs = 4096;    // argument sets of one probe
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Members of one kind of case only. The step program reads the first few of each list, the judge the rest.
const std::vector<std::string> picture_members = {"scene",      "camera", "size",    "output",        "profile",
                                                  "unit",       "delta",  "budget",  "exposure",      "reason",
                                                  "references", "mask",   "regions", "truth_differs", "choice"};
const std::vector<std::string> probe_members = {"probe",         "inputs",    "numbers", "expected",
                                                "expected_from", "tolerance", "together"};
const std::vector<std::string> shared_members = {"name",      "settings", "title",   "asked",  "hint",
                                                 "tier",      "points",   "student", "hidden", "rejects",
                                                 "functions", "needs",    "vary"};

std::vector<std::string> known_members() {
  std::vector<std::string> known = shared_members;
  for (const auto* more : {&picture_members, &probe_members}) known.insert(known.end(), more->begin(), more->end());
  return known;
}

glm::dvec3 parse_vec3(const Json& value, const std::string& where) {
  const std::vector<double> v = strict_json::vector(value, where, 3);
  return {v[0], v[1], v[2]};
}

CaseCamera parse_camera(const Json& object, const std::string& where) {
  strict_json::refuse_unknown(object, {"eye", "target", "up", "fov_y_degrees", "near", "far"}, where);
  CaseCamera camera;
  const auto read = [&](const char* name, auto& member, auto parse) {
    if (const Json* value = strict_json::optional(object, name)) member = parse(*value, where + ": " + name);
  };
  const auto any = [](const Json& v, const std::string& w) { return strict_json::number(v, w, -infinity, infinity); };
  const auto angle = [](const Json& v, const std::string& w) {
    const double degrees = strict_json::number(v, w, 0, 179);  // at 180 the tangent of half the angle is infinite
    if (degrees == 0) strict_json::refuse(v, w, "degrees above 0 and up to 179");
    return degrees;
  };
  read("eye", camera.eye, parse_vec3);
  read("target", camera.target, parse_vec3);
  read("up", camera.up, parse_vec3);
  read("fov_y_degrees", camera.fov_y_degrees, angle);
  read("near", camera.near, any);
  read("far", camera.far, any);
  if (camera.near && camera.far && *camera.near >= *camera.far) {
    throw Error(fmt::format("{}: near {} must be less than far {}", where, *camera.near, *camera.far));
  }
  return camera;
}

std::vector<Arguments> parse_inputs(const Json& list, const std::string& where) {
  if (!list.is_array() || list.empty() || list.size() > max_inputs) {
    strict_json::refuse(list, where, fmt::format("a list of 1..{} objects of named numbers", max_inputs));
  }
  std::vector<Arguments> inputs;
  for (const Json& object : list) {
    const std::string place = fmt::format("{}: input {}", where, inputs.size());
    if (!object.is_object()) strict_json::refuse(object, place, "an object of named numbers");
    Arguments& arguments = inputs.emplace_back();
    for (const auto& [name, value] : object.items()) {
      strict_json::name(name, place, "_[].");  // also a member of a uniform: u_lights[0].colour
      arguments.values[name] = strict_json::numbers(value, place + ": " + name);
    }
  }
  return inputs;
}

void parse_picture(const Json& object, const std::string& where, Case& c) {
  c.scene = strict_json::text(strict_json::required(object, "scene", where), where + ": scene", 1024);
  if (const Json* camera = strict_json::optional(object, "camera"))
    c.camera = parse_camera(*camera, where + ": camera");
  if (const Json* size = strict_json::optional(object, "size")) c.size = size_from_json(*size, where + ": size");
  if (const Json* output = strict_json::optional(object, "output")) {
    c.output = strict_json::name(*output, where + ": output", "_-");
  }
}

void parse_probe(const Json& object, const std::string& where, Case& c) {
  c.probe = strict_json::name(object["probe"], where + ": probe", "_");
  c.inputs = parse_inputs(strict_json::required(object, "inputs", where), where + ": inputs");
}

Json vec3_to_json(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

Json camera_to_json(const CaseCamera& camera) {
  Json object = Json::object();
  if (camera.eye) object["eye"] = vec3_to_json(*camera.eye);
  if (camera.target) object["target"] = vec3_to_json(*camera.target);
  if (camera.up) object["up"] = vec3_to_json(*camera.up);
  if (camera.fov_y_degrees) object["fov_y_degrees"] = *camera.fov_y_degrees;
  if (camera.near) object["near"] = *camera.near;
  if (camera.far) object["far"] = *camera.far;
  return object;
}

}  // namespace

glm::ivec2 size_from_json(const Json& value, const std::string& where) {
  if (!value.is_array() || value.size() != 2)
    strict_json::refuse(value, where, fmt::format("[width, height], each 1..{} pixels", max_size));
  const auto side = [&](int i) { return strict_json::integer(value[std::size_t(i)], where, 1, max_size); };
  return {side(0), side(1)};
}

Case parse_case(const Json& object, const std::string& where) {
  if (!object.is_object()) strict_json::refuse(object, where, "an object {...}");
  Case c;
  c.name = strict_json::name(strict_json::required(object, "name", where), where + ": name");
  const std::string place = fmt::format("{}: case '{}'", where, c.name);
  strict_json::refuse_unknown(object, known_members(), place);
  const bool is_probe = object.contains("probe");
  for (const std::string& member : is_probe ? picture_members : probe_members) {
    if (!object.contains(member)) continue;
    throw Error(fmt::format("{}: '{}' belongs to a {}, but this is a {}", place, member, is_probe ? "picture" : "probe",
                            is_probe ? "probe" : "picture"));
  }
  if (const Json* settings = strict_json::optional(object, "settings")) {
    c.settings = settings_from_json(*settings, place + ": settings");
  }
  is_probe ? parse_probe(object, place, c) : parse_picture(object, place, c);
  return c;
}

Json to_json(const Case& c) {
  Json object = {{"name", c.name}};
  for (const auto& [name, value] : c.settings) object["settings"][name] = setting_to_json(value);
  if (c.probe.empty()) {
    object["scene"] = c.scene;
    object["size"] = {c.size.x, c.size.y};
    object["output"] = c.output;
    if (Json camera = camera_to_json(c.camera); !camera.empty()) object["camera"] = std::move(camera);
    return object;
  }
  object["probe"] = c.probe;
  for (const Arguments& arguments : c.inputs) {
    Json input = Json::object();
    for (const auto& [name, values] : arguments.values) input[name] = strict_json::from_numbers(values);
    object["inputs"].push_back(std::move(input));
  }
  return object;
}

Json with_defaults(const Json& defaults, const Json& object, const std::string& where) {
  if (!object.is_object()) strict_json::refuse(object, where, "an object {...}");
  Json merged = object;
  for (const auto& [member, value] : defaults.items()) {
    if (member == "settings" || member == "camera") continue;
    if (!merged.contains(member)) merged[member] = value;
  }
  for (const char* group : {"settings", "camera"}) {
    const Json* values = strict_json::optional(defaults, group);
    if (!values) continue;
    Json& own = merged[group];
    if (own.is_null()) own = Json::object();
    if (own.is_object()) {
      Json all = *values;
      all.update(own);
      own = std::move(all);
    }
  }
  // Defaults may hold members for pictures and for probes; each kind inherits only its own.
  for (const std::string& member : object.contains("probe") ? picture_members : probe_members) {
    if (!object.contains(member)) merged.erase(member);
  }
  return merged;
}

std::vector<Json> case_objects(const Json& document, const std::string& where) {
  strict_json::refuse_unknown(document, {"schema", "step", "defaults", "cases"}, where);
  if (const Json* schema = strict_json::optional(document, "schema")) {
    strict_json::integer(*schema, where + ": schema", 1, 1);
  }
  const Json defaults = document.value("defaults", Json::object());
  std::vector<std::string> known = known_members();
  std::erase(known, "name");
  strict_json::refuse_unknown(defaults, known, where + ": defaults");
  const Json& cases = strict_json::required(document, "cases", where);
  if (!cases.is_array() || cases.empty()) strict_json::refuse(cases, where + ": cases", "a list of at least one case");
  std::vector<Json> objects;
  for (const Json& object : cases) {
    objects.push_back(with_defaults(defaults, object, fmt::format("{}: case {}", where, objects.size())));
  }
  return objects;
}

std::vector<Case> read_cases(const std::filesystem::path& file) {
  const std::string where = printable(file.string());
  const Json document = strict_json::parse(read_file(file, max_file), where);
  std::vector<Case> cases;
  std::set<std::string> names;
  for (const Json& object : case_objects(document, where)) {
    cases.push_back(parse_case(object, where));
    if (!names.insert(cases.back().name).second) {
      throw Error(fmt::format("{}: two cases are named '{}'", where, cases.back().name));
    }
  }
  return cases;
}

}  // namespace atelier
