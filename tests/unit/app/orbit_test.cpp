#include "app/window/orbit.hpp"

#include <glm/gtc/constants.hpp>
#include <limits>

#include "catch.hpp"

namespace {

using namespace atelier;

constexpr double pi = glm::pi<double>();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

/// Rounding of a few products of sines and cosines, relative to the numbers that they are multiplied with.
constexpr double rounding = 1e-14;

struct Row {
  const char* name;
  Camera camera;
};

const Row cameras[] = {
    {"plain", {.eye = {0, 1, 5}}},
    {"behind and below", {.eye = {-3, -2, -4}, .target = {1, 0.5, 0}}},
    {"close to the pole", {.eye = {1e-4, 10, 0}}},
    {"z up", {.eye = {4, 3, 1}, .up = {0, 0, 1}}},
    {"slanted up, not of unit length", {.eye = {4, 3, 1}, .up = {1, 2, -3}}},
    {"a million metres away", {.eye = {1e6, 1e6 + 1, 1e6 + 5}, .target = {1e6, 1e6, 1e6}}},
    {"tiny", {.eye = {0, 1e-6, 2e-6}}},
};

/// What a rounding error of the far-away coordinates themselves is worth in metres.
double tolerance(const Camera& camera) {
  return rounding * (glm::length(camera.eye) + glm::length(camera.target) + glm::distance(camera.eye, camera.target));
}

glm::dvec3 upward(const Orbit& orbit) {
  const glm::dvec3 forward = glm::normalize(orbit.target - eye_of(orbit));
  return glm::cross(glm::normalize(glm::cross(forward, orbit.up)), forward);
}

}  // namespace

TEST_CASE("an orbit starts at its camera", "[orbit]") {
  for (const auto& [name, camera] : cameras) {
    INFO(name);
    const Orbit orbit = orbit_of(camera);
    CHECK(glm::distance(eye_of(orbit), camera.eye) <= tolerance(camera));
    CHECK(orbit.target == camera.target);
    const Camera same = camera_on(orbit, camera, orbit);
    CHECK(same.target == camera.target);
    CHECK(same.up == camera.up);
    CHECK(same.height == camera.height);
  }
}

TEST_CASE("rotation keeps the distance and the up direction", "[orbit]") {
  for (const auto& [name, camera] : cameras) {
    INFO(name);
    const Orbit start = orbit_of(camera);
    Orbit orbit = start;
    for (int i = 0; i < 200; ++i) {
      orbit = turned(orbit, 0.37, i < 100 ? 0.2 : -0.3);
      CHECK(std::abs(glm::distance(eye_of(orbit), orbit.target) - start.distance) <= tolerance(camera));
      CHECK(glm::dot(upward(orbit), orbit.up) > 0);  // a camera that has flipped over the pole looks with its head down
    }
    CHECK(orbit.target == start.target);
  }
}

TEST_CASE("rotation stops before the poles", "[orbit]") {
  const Orbit orbit = orbit_of({.eye = {0, 1, 5}});
  CHECK(turned(orbit, 0, 100).elevation == highest_elevation);
  CHECK(turned(orbit, 0, -100).elevation == -highest_elevation);
  CHECK(highest_elevation < pi / 2);
}

TEST_CASE("a camera that looks straight down does not change until it is rotated", "[orbit]") {
  const Camera camera{.eye = {2, 10, 3}, .target = {2, 0, 3}};
  const Orbit orbit = orbit_of(camera);
  CHECK(glm::distance(eye_of(orbit), camera.eye) <= tolerance(camera));
  CHECK(turned(orbit, 0.1, 0).elevation == highest_elevation);
}

TEST_CASE("the heading is an angle around the up axis", "[orbit]") {
  const Orbit orbit = orbit_of({.eye = {0, 0, 5}});
  CHECK(orbit.heading == 0);
  const struct {
    const char* name;
    double turn;
    glm::dvec3 eye;
  } rows[] = {
      {"a quarter", pi / 2, {5, 0, 0}},
      {"a half", pi, {0, 0, -5}},
      {"a quarter back", -pi / 2, {-5, 0, 0}},
      {"a thousand times round", 2000 * pi, {0, 0, 5}},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    // 2000 pi itself is rounded to 1e-12, and the distance is 5.
    CHECK(glm::distance(eye_of(turned(orbit, row.turn, 0)), row.eye) < 1e-11);
    CHECK(std::abs(turned(orbit, row.turn, 0).heading) <= pi);
  }
}

TEST_CASE("a dolly is clamped and reversible", "[orbit]") {
  const Orbit orbit = orbit_of({.eye = {0, 3, 4}});
  CHECK(dollied(orbit, 1).distance == Approx(4.5));  // a tenth of 5 m nearer
  CHECK(dollied(dollied(orbit, 7), -7).distance == Approx(5));
  CHECK(dollied(orbit, 1e6).distance == orbit.nearest);
  CHECK(dollied(orbit, -1e6).distance == orbit.farthest);
  CHECK(orbit.nearest == Approx(5e-3));
  CHECK(orbit.farthest == Approx(5e3));
}

TEST_CASE("a pan keeps the grabbed point under the cursor", "[orbit]") {
  for (const auto& [name, camera] : cameras) {
    INFO(name);
    const Orbit start = turned(orbit_of(camera), 0.4, 0.1);
    const double pixel = metres_per_pixel(start, camera, 480);
    const Orbit right = panned(start, {10, 0}, pixel), down = panned(start, {0, 10}, pixel);
    const glm::dvec3 forward = glm::normalize(start.target - eye_of(start));
    const glm::dvec3 to_right = glm::normalize(glm::cross(forward, start.up));
    // The picture follows the cursor: the camera goes the other way, by as much as ten pixels show at the target.
    CHECK(glm::distance(right.target - start.target, -to_right * 10.0 * pixel) <= 10 * tolerance(camera));
    CHECK(glm::distance(down.target - start.target, upward(start) * 10.0 * pixel) <= 10 * tolerance(camera));
    CHECK(right.distance == start.distance);
  }
}

TEST_CASE("the size of a pixel at the target follows from the angle of view", "[orbit]") {
  const Orbit orbit = orbit_of({.eye = {0, 0, 10}});
  // 2 * 10 m * tan(45 degrees) over 500 pixels; the angle is a float, good to 1e-7.
  CHECK(metres_per_pixel(orbit, {.fov_y = float(pi / 2)}, 500) == Approx(0.04).epsilon(1e-6));
  CHECK(metres_per_pixel(orbit, {.projection = Projection::orthographic, .height = 3}, 300) == Approx(0.01));
  CHECK(std::isfinite(metres_per_pixel(orbit, {}, 0)));
}

TEST_CASE("an orthographic camera sees less when it comes nearer", "[orbit]") {
  const Camera camera{.eye = {0, 0, 10}, .projection = Projection::orthographic, .height = 4};
  const Orbit start = orbit_of(camera);
  // A float holds 7 digits.
  CHECK(camera_on(dollied(start, 1), camera, start).height == Approx(3.6).epsilon(1e-6));
}

TEST_CASE("an invalid camera still gives an orbit", "[orbit]") {
  const Orbit same_place = orbit_of({.eye = {1, 2, 3}, .target = {1, 2, 3}});
  CHECK(same_place.distance == 1);
  CHECK(glm::distance(eye_of(same_place), {1, 2, 4}) < rounding * 10);
  CHECK(orbit_of({.up = {0, 0, 0}}).up == glm::dvec3(0, 1, 0));
}

TEST_CASE("NaN and infinity do not move the camera", "[orbit]") {
  const Orbit orbit = orbit_of({});
  for (const double bad : {not_a_number, infinite, -infinite}) {
    CHECK(eye_of(turned(orbit, bad, 0)) == eye_of(orbit));
    CHECK(eye_of(turned(orbit, 0, bad)) == eye_of(orbit));
    CHECK(eye_of(dollied(orbit, bad)) == eye_of(orbit));
    CHECK(eye_of(panned(orbit, {bad, 0}, 1)) == eye_of(orbit));
    CHECK(eye_of(panned(orbit, {0, 1}, bad)) == eye_of(orbit));
  }
}
