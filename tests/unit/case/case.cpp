#include "case/case.hpp"

#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "base/strict_json.hpp"
#include "case/setting_json.hpp"
#include "catch.hpp"

using namespace atelier;
using nlohmann::json;
using test::error_of;

namespace {

Case parsed(const std::string& text) {
  return parse_case(strict_json::parse(text, "f.json"), "f.json");
}

std::vector<Case> cases_of(const std::string& text) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "f.json";
  write_file(file, text);
  return read_cases(file);
}

const char* const full_picture = R"({
  "name": "copper-8", "scene": "materials", "output": "normal", "size": [1, 4096],
  "camera": {"eye": [0, 1.5, 3], "target": [0, 0, 0], "up": [0, 1, 0], "fov_y_degrees": 179, "near": 1e-3, "far": 1e9},
  "settings": {"shading.normalised": true, "shading.lights": 64, "shading.gain": 0.5, "shading.kind": "phong",
               "shading.sky": [0.2, 0.5, 1], "shading.fog": "#ff0033"}})";

}  // namespace

TEST_CASE("a picture case with every member reaches the program unchanged") {
  for (const Case& c : {parsed(full_picture), parse_case(to_json(parsed(full_picture)), "again")}) {
    CHECK(c.name == "copper-8");
    CHECK(c.scene == "materials");
    CHECK(c.output == "normal");
    CHECK(c.size == glm::ivec2(1, 4096));
    CHECK(*c.camera.eye == glm::dvec3(0, 1.5, 3));
    CHECK(*c.camera.fov_y_degrees == 179);
    CHECK(*c.camera.far == 1e9);
    CHECK(c.settings.at("shading.normalised") == SettingValue(true));
    CHECK(c.settings.at("shading.lights") == SettingValue(64));
    CHECK(c.settings.at("shading.gain") == SettingValue(0.5));
    CHECK(c.settings.at("shading.kind") == SettingValue(std::string("phong")));
    CHECK(c.settings.at("shading.sky") == SettingValue(Colour(0.2, 0.5, 1)));
    CHECK(c.settings.at("shading.fog") == SettingValue(parse_colour("#ff0033").value()));
    CHECK(c.probe.empty());
  }
}

TEST_CASE("a setting of any type survives being written as JSON and read again") {
  const SettingValue rows[] = {true,
                               -7,
                               1.0,
                               1.0 / 3,
                               std::string("phong"),
                               std::string("16"),
                               Colour(0),
                               Colour(1),
                               Colour(1.0 / 3, -5e-324, 1e300)};
  for (const SettingValue& value : rows) {
    const std::string text = setting_to_json(value).dump();
    INFO(text);
    CHECK(setting_from_json(json::parse(text), "f.json") == value);
  }
  CHECK(setting_to_json(Colour(0.2, 0.5, 1)).dump() == "[0.2,0.5,1.0]");
}

TEST_CASE("a probe's inputs are flattened, and survive with non-finite numbers and the sign of zero") {
  const Case read = parsed(R"({"name": "p", "probe": "look_at", "inputs": [
    {"eye": [0, "nan", "-inf"], "points": [[1, 2], [3, 4]], "flip": true, "x": -0.0}, {"eye": [1, 2, 3]}]})");
  for (const Case& c : {read, parse_case(json::parse(to_json(read).dump()), "again")}) {
    REQUIRE(c.inputs.size() == 2);
    const Arguments& first = c.inputs[0];
    CHECK(std::isnan(first.vec3("eye").y));
    CHECK(std::isinf(first.vec3("eye").z));
    CHECK(first.numbers("points") == std::vector<double>{1, 2, 3, 4});
    CHECK(first.vec4("points") == glm::dvec4(1, 2, 3, 4));
    CHECK(first.integer("flip") == 1);
    CHECK(std::signbit(first.number("x")));
  }
}

TEST_CASE("a program never receives the judge's members") {
  const char* const of_the_judge[] = {"title",   "asked",     "hint",   "tier",       "points", "student",
                                      "rejects", "functions", "needs",  "profile",    "unit",   "delta",
                                      "budget",  "exposure",  "reason", "references", "hidden", "vary"};
  json picture = json::parse(full_picture);
  for (const char* member : of_the_judge) picture[member] = "secret";
  const json probe = {
      {"name", "p"}, {"probe", "f"}, {"inputs", {{{"x", 1}}}}, {"expected", "secret"}, {"tolerance", "secret"}};
  for (const json& object : {picture, probe}) {
    REQUIRE(object.dump().find("secret") != std::string::npos);
    CHECK(to_json(parse_case(object, "f.json")).dump().find("secret") == std::string::npos);
  }
}

TEST_CASE("broken cases are refused with file, case, member and what is allowed") {
  struct Row {
    const char *text, *words;
  };
  const Row rows[] = {
      {R"([])", "f.json: [] is not allowed; it takes an object"},
      {R"({"scene": "s"})", "f.json: member 'name' is missing"},
      {R"({"name": "A", "scene": "s"})", "f.json: name: \"A\" is not allowed; it takes a name of 1..64"},
      {R"({"name": "", "scene": "s"})", "f.json: name: \"\" is not allowed"},
      {R"({"name": "../x", "scene": "s"})", "f.json: name: \"../x\" is not allowed"},
      {R"({"name": "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa", "scene": "s"})", "1..64"},
      {R"({"name": 3, "scene": "s"})", "f.json: name: 3 is not allowed"},
      {R"({"name": "a"})", "f.json: case 'a': member 'scene' is missing"},
      {R"({"name": "a", "scene": ""})", "case 'a': scene: \"\" is not allowed"},
      {R"({"name": "a", "scene": "s\u001b"})", "case 'a': scene: \"s\\u001b\" is not allowed"},
      {R"({"name": "a", "scnee": "s"})", "f.json: case 'a': unknown member 'scnee'; did you mean 'scene'?"},
      {R"({"name": "a", "scene": "s", "size": [0, 5]})",
       "case 'a': size: 0 is not allowed; it takes a whole number 1..4096"},
      {R"({"name": "a", "scene": "s", "size": [5, 4097]})", "size: 4097"},
      {R"({"name": "a", "scene": "s", "size": [5.0, 5]})", "size: 5.0"},
      {R"({"name": "a", "scene": "s", "size": [1e300, 5]})", "size: 1e+300"},
      {R"({"name": "a", "scene": "s", "size": [18446744073709551615, 5]})", "size: 18446744073709551615"},
      {R"({"name": "a", "scene": "s", "size": [5]})", "size: [5] is not allowed; it takes [width, height]"},
      {R"({"name": "a", "scene": "s", "size": 5})", "size: 5 is not allowed"},
      {R"({"name": "a", "scene": "s", "camera": {"eyes": [0,0,0]}})",
       "camera: unknown member 'eyes'; did you mean 'eye'?"},
      {R"({"name": "a", "scene": "s", "camera": []})", "camera: [] is not allowed"},
      {R"({"name": "a", "scene": "s", "camera": {"eye": [0,0]}})",
       "camera: eye: [0,0] is not allowed; it takes 3 finite"},
      {R"({"name": "a", "scene": "s", "camera": {"up": [0,0,"nan"]}})", "camera: up: \"nan\" is not allowed"},
      {R"({"name": "a", "scene": "s", "camera": {"fov_y_degrees": 0}})", "fov_y_degrees: 0 is not allowed"},
      {R"({"name": "a", "scene": "s", "camera": {"fov_y_degrees": 179.5}})", "a number 0..179"},
      {R"({"name": "a", "scene": "s", "camera": {"near": 2, "far": 2}})", "camera: near 2 must be less than far 2"},
      {R"({"name": "a", "scene": "s", "output": "Normal"})", "output: \"Normal\""},
      {R"({"name": "a", "scene": "s", "settings": []})", "settings: [] is not allowed"},
      {R"({"name": "a", "scene": "s", "settings": {"x": null}})", "settings: x: null is not allowed"},
      {R"({"name": "a", "scene": "s", "settings": {"x": 3000000000}})", "settings: x: 3000000000 is not allowed"},
      {R"({"name": "a", "scene": "s", "settings": {"x": {}}})",
       "settings: x: {} is not allowed; it takes true, false, a number, the name of a choice, [red, green, blue] or "
       "\"#rrggbb\""},
      {R"({"name": "a", "scene": "s", "settings": {"x": []}})", "settings: x: [] is not allowed; it takes 3 finite"},
      {R"({"name": "a", "scene": "s", "settings": {"x": [1, 1]}})", "settings: x: [1,1] is not allowed; it takes 3"},
      {R"({"name": "a", "scene": "s", "settings": {"x": [1, 1, 1, 1]}})", "settings: x: [1,1,1,1] is not allowed"},
      {R"({"name": "a", "scene": "s", "settings": {"x": [1, 1, "1"]}})", "settings: x: \"1\" is not allowed"},
      {R"({"name": "a", "scene": "s", "settings": {"x": [1, true, 1]}})", "settings: x: true is not allowed"},
      {R"({"name": "a", "scene": "s", "settings": {"x": [1, [1], 1]}})", "settings: x: [1] is not allowed"},
      {R"({"name": "a", "scene": "s", "settings": {"x": "#ff00"}})",
       "settings: x: \"#ff00\" is not allowed; it takes a colour as \"#rrggbb\", six hexadecimal digits"},
      {R"({"name": "a", "scene": "s", "settings": {"x": "#ff00gg"}})", "settings: x: \"#ff00gg\" is not allowed"},
      {R"({"name": "a", "scene": "s", "settings": {"X": 1}})", "settings: \"X\""},
      {R"({"name": "a", "scene": "s", "inputs": [{}]})",
       "case 'a': 'inputs' belongs to a probe, but this is a picture"},
      {R"({"name": "a", "probe": "f", "scene": "s"})", "case 'a': 'scene' belongs to a picture, but this is a probe"},
      {R"({"name": "a", "probe": "f"})", "case 'a': member 'inputs' is missing"},
      {R"json({"name": "a", "probe": "f()", "inputs": [{}]})json", "probe: \"f()\""},
      {R"({"name": "a", "probe": "", "inputs": [{}]})", "probe: \"\""},
      {R"({"name": "a", "probe": "f", "inputs": []})", "inputs: [] is not allowed; it takes a list of 1..4096"},
      {R"({"name": "a", "probe": "f", "inputs": [3]})", "inputs: input 0: 3 is not allowed"},
      {R"({"name": "a", "probe": "f", "inputs": [{"x": "NaN"}]})", "input 0: x: \"NaN\" is not allowed"},
      {R"({"name": "a", "probe": "f", "inputs": [{"x": []}]})", "input 0: x: [] is not allowed; it takes at least one"},
      {R"({"name": "a", "probe": "f", "inputs": [{"x": {}}]})", "input 0: x: {} is not allowed"},
  };
  for (const Row& row : rows) {
    const std::string message = error_of([&] { parsed(row.text); });
    INFO(row.text << "\n-> " << message);
    CHECK(message.find(row.words) != std::string::npos);
  }
}

TEST_CASE("a file's defaults apply to its cases") {
  const std::vector<Case> cases = cases_of(R"({"schema": 1, "step": "02-x",
    "defaults": {"scene": "room", "size": [64, 32], "camera": {"near": 1, "far": 5}, "settings": {"a": 1, "b": 2}, "points": 2},
    "cases": [{"name": "one"},
              {"name": "two", "scene": "hall", "camera": {"far": 9}, "settings": {"b": 3}, "hint": "of the judge"},
              {"name": "three", "probe": "f", "inputs": [{"x": 1}]}]})");
  REQUIRE(cases.size() == 3);
  CHECK(cases[0].scene == "room");
  CHECK(cases[0].size == glm::ivec2(64, 32));
  CHECK(cases[1].scene == "hall");
  CHECK(*cases[1].camera.near == 1);
  CHECK(*cases[1].camera.far == 9);
  CHECK(cases[1].settings.at("a") == SettingValue(1));
  CHECK(cases[1].settings.at("b") == SettingValue(3));
  CHECK(cases[2].scene.empty());
  CHECK(cases[2].settings.size() == 2);
}

TEST_CASE("broken files of cases are refused") {
  struct Row {
    std::string text, words;
  };
  const Row rows[] = {
      {"", "f.json: parse error at line 1, column 1"},
      {"{\"cases\": [{\"name\": \"a\",,}]}", "f.json: parse error at line 1"},
      {"{\"cases\": [{\"name\": \"a\xff\"}]}", "invalid string: ill-formed UTF-8"},
      {R"([])", "f.json: [] is not allowed; it takes an object"},
      {R"({})", "f.json: member 'cases' is missing"},
      {R"({"cases": []})", "f.json: cases: [] is not allowed; it takes a list of at least one case"},
      {R"({"cases": [3]})", "f.json: case 0: 3 is not allowed"},
      {R"({"case": []})", "f.json: unknown member 'case'; did you mean 'cases'?"},
      {R"({"schema": 2, "cases": [{"name": "a", "scene": "s"}]})", "f.json: schema: 2 is not allowed"},
      {R"({"defaults": 3, "cases": [{"name": "a", "scene": "s"}]})", "f.json: defaults: 3 is not allowed"},
      {R"({"defaults": {"name": "b"}, "cases": [{"scene": "s"}]})", "f.json: defaults: unknown member 'name'"},
      {R"({"cases": [{"name": "a", "scene": "s"}, {"name": "a", "scene": "t"}]})", "two cases are named 'a'"},
      {R"({"cases": [{"name": "a", "name": "b", "scene": "s"}]})", "member \"name\" appears twice in one object"},
      {R"({"cases": [{"name": "a", "scene": "s", "settings": {"x": 1e999}}]})", "f.json: "},
      {std::string(100000, '['), "f.json: nested deeper than 32 levels"},
      {R"({"cases": )" + std::string(40, '[') + std::string(40, ']') + "}", "f.json: nested deeper than 32 levels"},
  };
  for (const Row& row : rows) {
    const std::string message = error_of([&] { cases_of(row.text); });
    INFO(row.text.substr(0, 120) << "\n-> " << message);
    CHECK(message.find(row.words) != std::string::npos);
  }
  CHECK(error_of([] { read_cases("/nowhere/cases.json"); }).find("/nowhere/cases.json") != std::string::npos);
}

TEST_CASE("missing arguments and wrong lengths are named") {
  Arguments arguments;
  arguments.values = {
      {"eye", {1, 2, 3}}, {"half", {0.5}}, {"nan", {std::nan("")}}, {"m", std::vector<double>(16, 2.0)}};
  CHECK(error_of([&] { arguments.vec3("eyes"); }) == "no argument 'eyes'; did you mean 'eye'?");
  CHECK(error_of([&] { arguments.vec2("eye"); }) == "argument 'eye' has 3 numbers; 2 are needed");
  CHECK(error_of([&] { arguments.integer("half"); }) == "argument 'half' is 0.5; a whole number is needed");
  CHECK(error_of([&] { arguments.integer("nan"); }) == "argument 'nan' is nan; a whole number is needed");
  arguments.values["m"][4] = 7;  // the first number of the second column
  CHECK(arguments.mat4("m")[1][0] == 7);
}
