// Drawing the numbers of cases that vary.
#include "judge/compare/variation.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "catch.hpp"

namespace atelier::judge::test {
namespace {

using nlohmann::json;

Case picture() {
  Case c;
  c.name = "sphere";
  c.scene = "sphere";
  c.settings = {{"kept", 3}, {"angle", 1.5}};
  return c;
}

Case probe() {
  Case c;
  c.name = "reflect";
  c.probe = "reflect";
  for (const double x : {1, 2, 3}) c.inputs.emplace_back().values = {{"v", {x, 0, 0}}, {"count", {x}}, {"kept", {7}}};
  return c;
}

Varied drawn(const Case& ask, const json& ranges, std::uint64_t seed) {
  return vary(ask, read_variation(ranges, ask, "vary"), seed);
}

const json of_picture = {
    {"camera", {{"eye", {{-1.0, 2.0, 3.0}, {1.0, 2.0, 4.0}}}, {"fov_y_degrees", {40, 50}}}},
    {"settings", {{"angle", {10.0, 20.0}}, {"samples", {4, 9}}, {"mode", {"plain", "fine"}}, {"on", {true, false}}}},
    {"size", {{64, 48}, {48, 64}}}};

TEST_CASE("a picture's numbers are within their ranges, and the others as they were") {
  std::set<std::string> modes;
  std::set<double> eyes;
  std::set<int> samples, widths;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Varied varied = drawn(picture(), of_picture, seed);
    const Case& c = varied.ask;
    INFO(varied.numbers);
    CHECK(c.name == "sphere-varied");
    CHECK(c.scene == "sphere");
    CHECK(std::abs(c.camera.eye.value().x) <= 1);
    CHECK(c.camera.eye->y == 2);
    CHECK((c.camera.eye->z >= 3 && c.camera.eye->z <= 4));
    CHECK_FALSE(c.camera.target);
    const double fov = c.camera.fov_y_degrees.value();
    CHECK((fov >= 40 && fov <= 50 && fov == std::floor(fov)));
    const double angle = std::get<double>(c.settings.at("angle"));
    CHECK((angle >= 10 && angle <= 20));
    CHECK(double(float(angle)) == angle);
    CHECK(std::get<int>(c.settings.at("kept")) == 3);
    CHECK(c.size.x + c.size.y == 112);
    samples.insert(std::get<int>(c.settings.at("samples")));
    modes.insert(std::get<std::string>(c.settings.at("mode")));
    widths.insert(c.size.x);
    eyes.insert(c.camera.eye->x);
  }
  CHECK(samples == std::set{4, 5, 6, 7, 8, 9});
  CHECK(modes.size() == 2);
  CHECK(widths == std::set{48, 64});
  CHECK(eyes.size() > 90);
}

TEST_CASE("a probe's inputs begin as those that they are like") {
  const json ranges = {{"count", 5},
                       {"like", {2, 0}},
                       {"inputs", {{"v", {{-1.0, 0.5, -1.0}, {1.0, 1.0, 1.0}}}, {"count", {10, 12}}}},
                       {"unit", {"v"}}};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Varied varied = drawn(probe(), ranges, seed);
    CHECK(varied.numbers == "5 other inputs");
    REQUIRE(varied.ask.inputs.size() == 5);
    for (const Arguments& input : varied.ask.inputs) {
      CHECK(input.number("kept") == 7);
      CHECK((input.number("count") >= 10 && input.number("count") <= 12));
      CHECK(std::abs(glm::length(input.vec3("v")) - 1) < 1e-15);
    }
  }
  const json only_count = {{"count", 4}, {"like", {2, 0}}, {"inputs", {{"count", {10, 12}}}}};
  const Varied alternating = drawn(probe(), only_count, 1);
  for (int i = 0; i < 4; ++i) CHECK(alternating.ask.inputs[std::size_t(i)].vec3("v").x == (i % 2 == 0 ? 3 : 1));
}

TEST_CASE("a range holds for every component, or for every vector of a list") {
  const Varied varied = drawn(probe(), {{"count", 1}, {"inputs", {{"v", {5.0, 6.0}}}}}, 1);
  const glm::dvec3 v = varied.ask.inputs[0].vec3("v");
  for (const double x : {v.x, v.y, v.z}) CHECK((x >= 5 && x <= 6));
  CHECK(v.x != v.y);

  Case list = probe();
  list.inputs[0].values["v"] = {0, 0, 0, 0, 0, 0};
  const Varied points = drawn(list, {{"count", 1}, {"inputs", {{"v", {{1, 10, 100}, {2, 20, 200}}}}}}, 1);
  const Numbers& numbers = points.ask.inputs[0].values.at("v");
  for (std::size_t i = 0; i < 6; ++i) {
    const double low = i % 3 == 0 ? 1 : i % 3 == 1 ? 10 : 100;
    CHECK((numbers[i] >= low && numbers[i] <= 2 * low));
  }
}

TEST_CASE("a colour is drawn by its components, and its ends are inclusive") {
  const Varied varied = drawn(picture(), {{"settings", {{"sky", {{0.0, 0.5, 1.0}, {0.25, 0.5, 1.0}}}}}}, 9);
  const Colour sky = std::get<Colour>(varied.ask.settings.at("sky"));
  CHECK((sky.r >= 0 && sky.r <= 0.25));
  CHECK(sky.g == 0.5);
  CHECK(sky.b == 1);
}

TEST_CASE("the same seed gives the same numbers on every machine; another seed or name gives others") {
  const std::string numbers = drawn(picture(), of_picture, 42).numbers;
  CHECK(numbers ==
        "camera.eye = (0.559814, 2, 3.19651), camera.fov_y_degrees = 50, angle = 12.2473, mode = fine, on = on, "
        "samples = 8, size = 64x48");
  CHECK(drawn(picture(), of_picture, 42).numbers == numbers);
  CHECK(drawn(picture(), of_picture, 43).numbers != numbers);
  Case other = picture();
  other.name = "ball";
  CHECK(drawn(other, of_picture, 42).numbers != numbers);
}

}  // namespace
}  // namespace atelier::judge::test
