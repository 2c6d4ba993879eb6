#include "judge/compare/judged_case.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "catch.hpp"

using namespace atelier;
using namespace atelier::judge;
using nlohmann::json;
using test::error_of;

namespace {

json picture() {
  return {{"name", "sphere"}, {"title", "Sphere"},      {"asked", "A sphere."}, {"hint", "Look."},
          {"points", 2},      {"rejects", {"no-half"}}, {"scene", "sphere"}};
}

json probe() {
  return {{"name", "look-at"},
          {"title", "look_at"},
          {"asked", "A matrix."},
          {"hint", "Look."},
          {"points", 1},
          {"rejects", {"transposed"}},
          {"probe", "look_at"},
          {"inputs", {{{"x", 1}}, {{"x", 2}}}},
          {"expected", {{1, 2}, {"nan", "-inf"}}}};
}

json document(const json& one_case) {
  return {{"schema", 1}, {"step", "02-blinn-phong"}, {"cases", {one_case}}};
}

CaseFile read(const json& whole) {
  const TemporaryFolder folder;
  write_file(folder.path() / "cases.json", whole.dump());
  return read_case_file(folder.path() / "cases.json");
}

JudgedCase read_one(const json& one_case) {
  return read(document(one_case)).cases.at(0);
}

/// `base` with some members replaced, or removed where null.
json with(json base, const json& changes) {
  base.merge_patch(changes);
  return base;
}

}  // namespace

TEST_CASE("a picture case takes its defaults") {
  const CaseFile file = read(document(picture()));
  CHECK(file.step == "02-blinn-phong");
  const JudgedCase& c = file.cases.at(0);
  CHECK(c.ask.name == "sphere");
  CHECK(c.tier == "core");
  CHECK(c.student);
  CHECK_FALSE(c.hidden);
  CHECK(c.profile == Profile::strict);
  CHECK(c.unit == Unit::colour);
  CHECK(c.delta == 3);
  CHECK(c.budget == 4);
  CHECK(c.exposure == 1);
  REQUIRE(c.references.size() == 1);
  CHECK(c.references[0] == file.path.parent_path() / "references/sphere.exr");
}

TEST_CASE("a picture case takes every member") {
  const json pole = {{"name", "the pole"}, {"at", {120, 0, 16, 8}}, {"weight", 2.5}};
  const JudgedCase c = read_one(with(picture(), {{"tier", "challenge"},
                                                 {"student", false},
                                                 {"hidden", true},
                                                 {"functions", {"shade_point"}},
                                                 {"output", "normal"},
                                                 {"profile", "robust"},
                                                 {"unit", "degrees"},
                                                 {"delta", 0.5},
                                                 {"budget", 7},
                                                 {"reason", "Half a degree is the mesh."},
                                                 {"mask", {{0, 0, 64, 256}}},
                                                 {"regions", {pole}},
                                                 {"references", {"a.exr", "b.png"}}}));
  CHECK(c.tier == "challenge");
  CHECK_FALSE(c.student);
  CHECK(c.hidden);
  CHECK(c.functions == std::vector<std::string>{"shade_point"});
  CHECK(c.profile == Profile::robust);
  CHECK(c.unit == Unit::degrees);
  CHECK(c.delta == 0.5);
  CHECK(c.budget == 7);
  CHECK(c.references.size() == 2);
  CHECK(c.mask == std::vector<Rectangle>{{0, 0, 64, 256}});  // a quarter of 256x256: as much as may be
  CHECK(c.regions == std::vector<Region>{{"the pole", {120, 0, 16, 8}, 2.5}});
  const JudgedCase exact = read_one(with(picture(), {{"profile", "exact"}, {"unit", "encoded"}}));
  CHECK(exact.delta == 0);
  CHECK(exact.budget == 0);
}

TEST_CASE("a probe's values are in the file or beside it") {
  const JudgedCase here = read_one(probe());
  CHECK(here.profile == Profile::values);
  REQUIRE(here.expected.size() == 2);
  CHECK(here.expected[0] == Numbers{1, 2});
  CHECK(std::isnan(here.expected[1][0]));
  CHECK(std::isinf(here.expected[1][1]));
  CHECK(here.expected_file.empty());
  const JudgedCase beside = read_one(with(probe(), {{"expected", nullptr}, {"expected_from", "reference"}}));
  CHECK(beside.expected.empty());
  CHECK(beside.expected_file.filename() == "look-at.values.json");
  const json tolerance = {{"absolute", 1e-6}, {"relative", 1e-5}, {"ulp", 4}, {"reason", "Single precision."}};
  const JudgedCase near = read_one(with(probe(), {{"tolerance", tolerance}}));
  CHECK(near.tolerance.absolute == 1e-6);
  CHECK(near.tolerance.relative == 1e-5);
  CHECK(near.tolerance.ulp == 4);
}

TEST_CASE("defaults apply only to cases of their kind") {
  json whole = document(with(picture(), {{"scene", nullptr}}));
  whole["cases"].push_back(probe());
  whole["defaults"] = {
      {"scene", "room"}, {"delta", 5}, {"reason", "Noise."}, {"tolerance", {{"ulp", 2}, {"reason", "R"}}}};
  const CaseFile file = read(whole);
  CHECK(file.cases[0].ask.scene == "room");
  CHECK(file.cases[0].delta == 5);
  CHECK(file.cases[1].tolerance.ulp == 2);
}

TEST_CASE("broken judged cases are refused with file, case, member and what is allowed") {
  struct Row {
    json one_case;
    const char* words;
  };
  const json wide = {{"delta", 9}};
  const auto masked = [](const json& mask) { return json{{"mask", mask}, {"reason", "Noise."}}; };
  const auto regions = [](const json& region) { return json{{"regions", json::array({region})}}; };
  const Row rows[] = {
      {with(picture(), {{"title", nullptr}}), "case 'sphere': member 'title' is missing"},
      {with(picture(), {{"title", "a\nb"}}), "case 'sphere': title: \"a\\nb\" is not allowed"},
      {with(picture(), {{"asked", nullptr}}), "member 'asked' is missing"},
      {with(picture(), {{"hint", nullptr}}), "member 'hint' is missing"},
      {with(picture(), {{"points", nullptr}}), "member 'points' is missing"},
      {with(picture(), {{"points", -1}}), "points: -1 is not allowed; it takes a number 0..1000"},
      {with(picture(), {{"points", 1001}}), "points: 1001"},
      {with(picture(), {{"points", "2"}}), "points: \"2\""},
      {with(picture(), {{"tier", "easy"}}), "tier: \"easy\" is not allowed; it takes core, further, challenge"},
      {with(picture(), {{"student", 1}}), "student: 1 is not allowed; it takes true or false"},
      {with(picture(), {{"hidden", "yes"}}), "hidden: \"yes\" is not allowed; it takes true or false"},
      {with(picture(), {{"rejects", nullptr}}), "must name a mistake that it catches in 'rejects'"},
      {with(picture(), {{"rejects", json::array()}}), "must name a mistake that it catches in 'rejects'"},
      {with(picture(), {{"rejects", {"a", "a"}}}), "rejects: 'a' appears twice"},
      {with(picture(), {{"rejects", {"A"}}}), "rejects: \"A\" is not allowed"},
      {with(picture(), {{"needs", {"clip_control"}}}), "must have 0 points"},
      {with(picture(), {{"rejcets", {"a"}}}), "unknown member 'rejcets'; did you mean 'rejects'?"},
      {with(picture(), {{"profile", "lenient"}}),
       "profile: \"lenient\" is not allowed; it takes strict, robust, exact"},
      {with(picture(), {{"profile", "values"}}), "profile: \"values\" is not allowed"},
      {with(picture(), {{"unit", "pixels"}}), "it takes colour, encoded, degrees, number"},
      {with(picture(), {{"delta", 9}}), "'reason' is missing: delta 9 and budget 4"},
      {with(picture(), {{"budget", 5}}), "'reason' is missing: delta 3 and budget 5"},
      {with(picture(), {{"unit", "degrees"}}), "'delta' is missing: degrees and numbers have no default"},
      {with(picture(), {{"unit", "degrees"}, {"delta", 3}}), "'reason' is missing"},
      {with(picture(), {{"delta", 0}, {"reason", "r"}}), "delta: 0 is not allowed"},
      {with(picture(), {{"delta", 256}, {"reason", "r"}}), "delta: 256 is not allowed; it takes a number 0..255"},
      {with(picture(), {{"budget", 65537}, {"reason", "r"}}),
       "budget: 65537 is not allowed; it takes a whole number 0..65536"},
      {with(picture(), {{"budget", 1.5}, {"reason", "r"}}), "budget: 1.5"},
      {with(picture(), {{"reason", ""}}), "reason: \"\" is not allowed"},
      {with(picture(), {{"profile", "exact"}, {"delta", 1}}),
       "profile 'exact' allows no difference, so it takes no 'delta'"},
      {with(picture(), {{"exposure", 0}}), "exposure: 0 is not allowed"},
      {with(picture(), {{"exposure", 2}, {"unit", "encoded"}}), "'exposure' is only allowed with unit 'colour'"},
      {with(picture(), {{"mask", {{0, 0, 8, 8}}}}), "'reason' is missing: a mask needs one"},
      {with(picture(), masked(json::array())), "mask: [] is not allowed; it takes a list of rectangles"},
      {with(picture(), masked({0, 0, 8, 8})), "mask: rectangle 0: 0 is not allowed; it takes [x, y, width, height]"},
      {with(picture(), masked({{0, 0, 8}})), "mask: rectangle 0: [0,0,8] is not allowed"},
      {with(picture(), masked({{0, 0, 8, 1.5}})), "mask: rectangle 0: [0,0,8,1.5] is not allowed"},
      {with(picture(), masked({{0, 0, 8, 8}, {-1, 0, 8, 8}})), "mask: rectangle 1: [-1,0,8,8] is not allowed"},
      {with(picture(), masked({{0, 0, 0, 8}})), "mask: rectangle 0: [0,0,0,8] is not allowed"},
      {with(picture(), masked({{250, 0, 7, 8}})),
       "[250,0,7,8] is not allowed; it takes [x, y, width, height] in whole"},
      {with(picture(), masked({{1, 0, 9223372036854775807, 8}})), "inside 256x256"},
      {with(picture(), masked({{0, 0, 65, 256}})), "mask: 0.254 of the picture is masked; at most 0.25 may be"},
      {with(probe(), {{"mask", {{0, 0, 8, 8}}}}), "'mask' belongs to a picture, but this is a probe"},
      {with(picture(), {{"regions", json::object()}}), "regions: {} is not allowed; it takes a list of objects"},
      {with(picture(), regions({{"name", "a"}, {"at", {0, 0, 8, 8}}})),
       "regions: region 0: member 'weight' is missing"},
      {with(picture(), regions({{"name", "a"}, {"at", {0, 0, 8, 8}}, {"weight", 0}})),
       "regions: region 0: weight: 0 is not allowed; it takes a number 0.01..100"},
      {with(picture(), regions({{"name", "a"}, {"at", {0, 0, 8, 257}}, {"weight", 2}})),
       "regions: region 0: at: [0,0,8,257] is not allowed"},
      {with(picture(), regions({{"nmae", "a"}, {"at", {0, 0, 8, 8}}, {"weight", 2}})), "unknown member 'nmae'"},
      {with(picture(), {{"regions",
                         {{{"name", "a"}, {"at", {0, 0, 8, 8}}, {"weight", 2}},
                          {{"name", "b"}, {"at", {7, 7, 8, 8}}, {"weight", 3}}}}}),
       "regions: region 1: 'b' overlaps 'a'; regions must not overlap"},
      {with(picture(), {{"references", json::array()}}), "references: [] is not allowed"},
      {with(picture(), {{"references", {"../a.exr"}}}), "references: \"../a.exr\" is not allowed"},
      {with(picture(), {{"references", {"a.jpg"}}}), "references: \"a.jpg\" is not allowed"},
      {with(picture(), {{"tolerance", json::object()}}), "'tolerance' belongs to a probe, but this is a picture"},
      {with(probe(), wide), "'delta' belongs to a picture, but this is a probe"},
      {with(probe(), {{"expected", nullptr}}), "case 'look-at': member 'expected' is missing"},
      {with(probe(), {{"expected", {{1}}}}), "'expected' has 1 lists for 2 inputs"},
      {with(probe(), {{"expected", {{1}, {"NaN"}}}}), "expected 1: \"NaN\" is not allowed"},
      {with(probe(), {{"expected", {{1}, json::array()}}}), "expected 1: [] is not allowed"},
      {with(probe(), {{"expected_from", "reference"}}), "'expected' and 'expected_from' exclude each other"},
      {with(probe(), {{"expected_from", "file"}}), "expected_from: \"file\" is not allowed; it takes reference"},
      {with(probe(), {{"tolerance", {{"absolute", 1e-6}}}}), "tolerance: member 'reason' is missing"},
      {with(probe(), {{"tolerance", {{"absolute", -1}}}}), "tolerance: absolute: -1 is not allowed"},
      {with(probe(), {{"tolerance", {{"relative", 2}}}}), "tolerance: relative: 2 is not allowed"},
      {with(probe(), {{"tolerance", {{"ulp", 1.5}}}}), "tolerance: ulp: 1.5 is not allowed"},
      {with(probe(), {{"tolerance", {{"abs", 1}}}}), "tolerance: unknown member 'abs'"},
      {with(probe(), {{"tolerance", 3}}), "tolerance: 3 is not allowed"},
  };
  for (const Row& row : rows) {
    const std::string message = error_of([&] { read_one(row.one_case); });
    INFO(row.one_case.dump() << "\n-> " << message);
    CHECK(test::mentions(message, {"cases.json: case '", row.words}));
  }
}

TEST_CASE("broken ranges of numbers that vary are refused with file, case, member and what is allowed") {
  const auto of_picture = [](const json& vary) { return with(picture(), {{"vary", vary}}); };
  const auto of_probe = [](const json& vary) { return with(probe(), {{"vary", vary}}); };
  const auto of_x = [&](const json& range) { return of_probe({{"count", 2}, {"inputs", {{"x", range}}}}); };
  const json size = {{"size", {{64, 48}}}};
  struct Row {
    json one_case;
    const char* words;
  };
  const Row rows[] = {
      {of_picture(3), "case 'sphere': vary: 3 is not allowed"},
      {of_picture(json::object()), "vary: there must be a range for something"},
      {of_picture({{"camra", 1}}), "vary: unknown member 'camra'; did you mean 'camera'?"},
      {of_picture({{"count", 2}}), "vary: unknown member 'count'"},
      {of_picture({{"camera", {{"eye", {{0, 1}, {1, 2}}}}}}), "vary: camera: eye: [[0,1],[1,2]] is not allowed"},
      {of_picture({{"camera", {{"eye", {1, 2}}}}}), "it takes [[x, y, z], [x, y, z]]"},
      {of_picture({{"camera", {{"roll", {1, 2}}}}}), "vary: camera: unknown member 'roll'"},
      {of_picture({{"camera", {{"fov_y_degrees", {0, 40}}}}}), "it takes degrees above 0 and up to 179"},
      {of_picture({{"camera", {{"near", {2, 1}}}}}), "vary: camera: near: [2,1] is not allowed; it takes [low, high]"},
      {of_picture({{"size", json::array()}}), "vary: size: [] is not allowed; it takes a list of sizes"},
      {of_picture({{"size", {64, 48}}}), "vary: size: 64 is not allowed; it takes [width, height]"},
      {of_picture({{"size", {{64, 5000}}}}), "vary: size: 5000 is not allowed"},
      {of_picture({{"settings", {{"bias", {1}}}}}), "vary: settings: bias: [1] is not allowed"},
      {of_picture({{"settings", {{"bias", {3, 3}}}}}), "it takes a range with something to draw, low below high"},
      {of_picture({{"settings", {{"bias", {"slope", nullptr}}}}}), "vary: settings: bias: null is not allowed"},
      {of_picture({{"settings", {{"Bias", {1, 2}}}}}), "vary: settings: \"Bias\" is not allowed"},
      {with(of_picture(size), {{"mask", {{0, 0, 8, 8}}}, {"reason", "Noise."}}),
       "vary: camera and size are not allowed with 'mask' or 'regions'"},
      {with(of_picture(size), {{"points", 0}, {"needs", {"clip_control"}}}), "'vary' is not allowed with 'needs'"},
      {with(of_picture(size), {{"name", std::string(58, 'a')}}),
       "vary: the case's name must have at most 57 characters"},
      {of_probe({{"inputs", {{"x", {1, 2}}}}}), "case 'look-at': vary: member 'count' is missing"},
      {of_probe({{"count", 2}}), "vary: member 'inputs' is missing"},
      {of_probe({{"count", 0}, {"inputs", {{"x", {1, 2}}}}}), "vary: count: 0 is not allowed; it takes a whole"},
      {of_probe({{"count", 2}, {"inputs", json::object()}}), "vary: inputs: {} is not allowed"},
      {of_probe({{"count", 2}, {"inputs", {{"y", {1, 2}}}}}), "vary: inputs: y: input 0 has no such member"},
      {of_probe({{"count", 2}, {"like", {2}}, {"inputs", {{"x", {1, 2}}}}}), "vary: like: 2 is not allowed"},
      {of_probe({{"count", 2}, {"unit", {"y"}}, {"inputs", {{"x", {1, 2}}}}}), "vary: unit: 'y' is not drawn"},
      {of_x({2, 1}), "vary: inputs: x: [2,1] is not allowed; it takes [low, high]"},
      {of_x({1, 2, 3}), "it takes [low, high]"},
      {of_x({{1, 2}, {3}}), "it takes [low, high]"},
      {of_x({{1, 2}, {3, 4}}), "two lists whose length divides 1"},
      {of_x({1, "inf"}), "vary: inputs: x: [1,\"inf\"] is not allowed"},
      {of_picture({{"scene", 1}}), "vary: unknown member 'scene'"},
  };
  for (const Row& row : rows) {
    const std::string message = error_of([&] { read_one(row.one_case); });
    INFO(row.one_case.dump() << "\n-> " << message);
    CHECK(test::mentions(message, {"cases.json: case '", row.words}));
  }
}

TEST_CASE("a drawn case takes no other case's name") {
  json whole = document(with(picture(), {{"vary", {{"size", {{64, 48}}}}}}));
  whole["cases"].push_back(with(picture(), {{"name", "sphere-varied"}}));
  CHECK(test::mentions(error_of([&] { read(whole); }), {"case 'sphere'", "'sphere-varied' is another case's name"}));
}

TEST_CASE("broken case files are refused") {
  struct Row {
    json changes;
    const char* words;
  };
  const Row rows[] = {
      {{{"schema", nullptr}}, "cases.json: member 'schema' is missing"},
      {{{"schema", 2}}, "cases.json: schema: 2 is not allowed"},
      {{{"step", nullptr}}, "cases.json: member 'step' is missing"},
      {{{"step", "blinn"}}, "cases.json: step: \"blinn\" is not allowed"},
      {{{"step", "2-blinn"}}, "cases.json: step: \"2-blinn\" is not allowed"},
      {{{"cases", nullptr}}, "cases.json: member 'cases' is missing"},
      {{{"cases", {picture(), picture()}}}, "cases.json: two cases are named 'sphere'"},
  };
  for (const Row& row : rows) {
    const std::string message = error_of([&] { read(with(document(picture()), row.changes)); });
    INFO(row.changes.dump() << " -> " << message);
    CHECK(message.find(row.words) != std::string::npos);
  }
}

TEST_CASE("a case without points needs neither hint nor mistakes") {
  CHECK(error_of([] { read_one(with(picture(), {{"points", 0}, {"hint", nullptr}, {"rejects", nullptr}})); }) == "");
  CHECK(error_of([] { read_one(with(picture(), {{"points", 0}, {"needs", {"clip_control"}}})); }) == "");
}
