#include "app/picture.hpp"

#include "../gl/contexts.hpp"
#include "catch.hpp"
#include "studio.hpp"

namespace {

using namespace atelier;
using test::error_of;
using test::mentions;
using test::small_picture;
using test::Studio;

}  // namespace

TEST_CASE("a case's camera changes only the members that it has", "[picture]") {
  const Camera own{.eye = {1, 2, 3}, .target = {4, 5, 6}, .up = {0, 0, 1}, .fov_y = 0.5f, .near = 0.2f, .far = 50};
  const Camera same = apply({}, own);
  CHECK(same.eye == own.eye);
  CHECK(same.target == own.target);
  CHECK(same.up == own.up);
  CHECK(same.fov_y == own.fov_y);

  CaseCamera change;
  change.eye = glm::dvec3(1e6, 0, 0);
  CHECK(apply(change, own).eye == glm::dvec3(1e6, 0, 0));
  CHECK(apply(change, own).target == own.target);
  change = {};
  change.target = glm::dvec3(7);
  change.up = glm::dvec3(1, 0, 0);
  CHECK(apply(change, own).target == glm::dvec3(7));
  CHECK(apply(change, own).up == glm::vec3(1, 0, 0));
  CHECK(apply(change, own).eye == own.eye);
  change = {};
  change.fov_y_degrees = 90;
  change.near = 0.5;
  change.far = 7;
  CHECK(apply(change, own).fov_y == Approx(1.5707963));  // radians, to a float's digits
  CHECK(apply(change, own).near == 0.5f);
  CHECK(apply(change, own).far == 7.0f);
}

TEST_CASE("a painter draws the picture of a case", "[picture]") {
  Studio studio;
  const Image red = studio.painter->paint(small_picture());
  CHECK(red.width() == 32);
  CHECK(red.height() == 24);
  const Rgba middle = red.at(16, 12), corner = red.at(0, 0);
  CHECK(middle.r > 2 * middle.b);
  CHECK(corner == Rgba{0.02f, 0.03f, 0.05f, 1});  // the background, to the bit: floats are drawn and read

  Case blue = small_picture();
  blue.settings["tint.colour"] = std::string("blue");
  CHECK(studio.painter->paint(blue).at(16, 12).b > studio.painter->paint(blue).at(16, 12).r);
  CHECK(studio.painter->paint(small_picture()) == red);  // nothing stays from one case to the next

  Case normal = small_picture();
  normal.output = "normal";
  const Rgba direction = studio.painter->paint(normal).at(16, 12);
  const glm::vec3 n = glm::vec3(direction.r, direction.g, direction.b) * 2.0f - 1.0f;
  CHECK(glm::length(n) == Approx(1).margin(1e-5));  // the shader normalises in floats

  Case ring = small_picture();
  ring.scene = "ring";
  CHECK_FALSE(studio.painter->paint(ring) == red);
  studio.painter->paint(ring, 1.25);
  CHECK(studio.step.last_time == 1.25);
}

TEST_CASE("a painter reports what it cannot draw", "[picture]") {
  Studio studio;
  const struct {
    const char* name;
    void (*spoil)(Case&);
    std::initializer_list<std::string_view> answer;
  } rows[] = {
      {"scene", [](Case& c) { c.scene = "hall"; }, {"hall", "box", "ring"}},
      {"output", [](Case& c) { c.output = "colr"; }, {"colr", "colour", "normal"}},
      {"setting", [](Case& c) { c.settings["tint.color"] = true; }, {"tint.color", "tint.colour"}},
      {"setting's range", [](Case& c) { c.settings["tint.brightness"] = 5.0; }, {"tint.brightness", "5", "0..4"}},
      {"model", [](Case& c) { c.scene = "missing.obj"; }, {"missing.obj"}},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    Case bad = small_picture();
    row.spoil(bad);
    CHECK(mentions(error_of([&] { studio.painter->paint(bad); }), row.answer));
  }
}

TEST_CASE("a painter calls probes", "[picture]") {
  Studio studio;
  Case probe;
  probe.probe = "twice";
  probe.inputs.resize(2);
  probe.inputs[0].values["x"] = {3};
  probe.inputs[1].values["x"] = {-0.5};
  CHECK(studio.painter->probe(probe) == std::vector<Numbers>{{6}, {-1}});
  probe.inputs[1].values.clear();
  CHECK(mentions(error_of([&] { studio.painter->probe(probe); }), {"x"}));
  probe.probe = "thrice";
  CHECK(mentions(error_of([&] { studio.painter->probe(probe); }), {"thrice", "twice"}));
}

TEST_CASE("a probe of a shader is a group that names its expression", "[picture]") {
  Studio studio;
  Gl& gl = studio.painter->gl();
  const Implementations nothing;
  ShaderProbe probe(gl, nothing);
  Arguments arguments;
  arguments.values["x"] = {3};
  gl.restart_counts();
  CHECK(probe.evaluate("", "vec4(2.0 * x)", arguments) == glm::vec4(6));
  const std::vector<GlGroup> expected = {
      {.depth = 0, .name = "probe: vec4(2.0 * x)", .passes = 1, .draws = 1, .triangles = 1}};
  CHECK(gl.groups() == expected);
}
