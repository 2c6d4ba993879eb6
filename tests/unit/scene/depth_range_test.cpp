#include "scene/depth_range.hpp"

#include <random>

#include "catch.hpp"
#include "scene/builder.hpp"
#include "scene/shapes.hpp"

namespace {

using namespace atelier;

Box3 box(glm::dvec3 low, glm::dvec3 high) {
  Box3 made;
  made.add(low), made.add(high);
  return made;
}

/// From the origin along -z: 90 degrees upright, so that the view is as high as twice the depth.
Camera straight() {
  return {.eye = {0, 0, 0}, .target = {0, 0, -1}, .fov_y = degrees(90), .near = 0.01f, .far = 1000};
}

/// The contract of step 01's look_at: what stands in for an up along the view.
glm::dvec3 axis_least_along(const glm::dvec3& forward) {
  int least = 0;
  for (int axis : {1, 2})
    if (std::abs(forward[axis]) < std::abs(forward[least])) least = axis;
  glm::dvec3 made(0);
  made[least] = 1;
  return made;
}

}  // namespace

TEST_CASE("the depths of a box in view", "[depth_range]") {
  const struct {
    const char* name;
    Box3 box;
    std::optional<DepthRange> expected;
  } rows[] = {
      {"before the eye", box({-1, -1, -6}, {1, 1, -4}), DepthRange{4, 6}},
      {"around the eye", box({-9, -9, -9}, {9, 9, 9}), DepthRange{0, 9}},
      {"behind the eye", box({-1, -1, 2}, {1, 1, 4}), std::nullopt},
      // The right edge of the view is x = 2 z (aspect 2): it enters the box at x = 1, where z = 0.5.
      {"from behind the eye into the view, beside it", box({1, -1, -6}, {2, 1, 6}), DepthRange{0.5, 6}},
      {"to the right", box({20, -1, -6}, {22, 1, -4}), std::nullopt},
      // The right edge is x = 2 z too: it enters this box at x = 10, where z = 5.
      {"cut by the edge of the view", box({10, -1, -8}, {30, 1, -1}), DepthRange{5, 8}},
      {"wider than the view, no corner in it", box({-100, -0.1, -6}, {100, 0.1, -4}), DepthRange{4, 6}},
      {"flat and edge on", box({-1, 0, -6}, {1, 0, -4}), DepthRange{4, 6}},
      {"empty", Box3{}, std::nullopt},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    const auto range = visible_depths(straight(), 2, row.box);
    REQUIRE(range.has_value() == row.expected.has_value());
    if (!range) continue;
    // The camera's angle is a float: its tangent is off by 4e-8.
    CHECK(range->near == Approx(row.expected->near).epsilon(1e-7).margin(1e-12));
    CHECK(range->far == Approx(row.expected->far).epsilon(1e-7).margin(1e-12));
  }
}

TEST_CASE("an orthographic camera sees a slab, behind itself too", "[depth_range]") {
  Camera camera = straight();
  camera.projection = Projection::orthographic;
  camera.height = 4;
  const auto both = visible_depths(camera, 2, box({-1, -1, -6}, {1, 1, 3}));
  REQUIRE(both);
  CHECK(both->near == Approx(-3));
  CHECK(both->far == Approx(6));
  CHECK(visible_depths(camera, 2, box({3.9, 0, -1}, {9, 1, 0})));
  CHECK_FALSE(visible_depths(camera, 2, box({4.1, 0, -1}, {9, 1, 0})));
  CHECK_FALSE(visible_depths(camera, 2, box({0, 2.1, -1}, {1, 9, 0})));
}

TEST_CASE("no visible point of a box is nearer or farther than its depths, and some come close", "[depth_range]") {
  std::mt19937 random(7);
  const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  const auto point = [&](double size) {
    return glm::dvec3(number(-size, size), number(-size, size), number(-size, size));
  };
  int seen = 0, seen_along = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Camera camera{.eye = point(4), .target = point(4), .up = glm::vec3(point(1)), .fov_y = float(number(0.2, 2.5))};
    if (trial % 3 == 0) camera.projection = Projection::orthographic;
    const bool along = trial % 10 == 0;
    if (along) camera.up = glm::vec3(camera.target - camera.eye);
    const double aspect = number(0.3, 3);
    Box3 b;
    b.add(point(5)), b.add(point(5));
    const auto range = visible_depths(camera, aspect, b);
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    const glm::dvec3 given_up = along ? axis_least_along(forward) : glm::dvec3(camera.up);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, given_up)), up = glm::cross(right, forward);
    double least = 1e300, most = -1e300;
    int visible = 0;
    for (int i = 0; i < 2000; ++i) {
      const glm::dvec3 p = glm::mix(b.low, b.high, glm::dvec3(number(0, 1), number(0, 1), number(0, 1))) - camera.eye;
      const double z = glm::dot(forward, p);
      const bool perspective = camera.projection == Projection::perspective;
      const double half = perspective ? z * std::tan(double(camera.fov_y) / 2) : double(camera.height) / 2;
      if ((perspective && z <= 0) || std::abs(glm::dot(up, p)) > half || std::abs(glm::dot(right, p)) > half * aspect)
        continue;
      least = std::min(least, z), most = std::max(most, z);
      ++visible;
    }
    if (least > most) continue;
    ++seen;
    seen_along += along;
    INFO("trial " << trial);
    REQUIRE(range);
    CHECK(range->near <= least + 1e-9);
    CHECK(range->far >= most - 1e-9);
    // Of a part of the box that a hundred points have hit, corners are left unvisited, but not half of the range.
    if (visible > 100) CHECK(range->far - range->near < 2 * (most - least) + 1);
  }
  CHECK(seen > 100);
  CHECK(seen_along > 10);
}

TEST_CASE("for a parallel up vector, the picture is rotated as by the view matrix", "[depth_range]") {
  // At depth 4 the view is 8 m high and 24 m wide: what lies 6 m aside is seen to the right and not above.
  const struct {
    const char* name;
    glm::dvec3 target;
    glm::vec3 up;
    glm::dvec3 right;
  } rows[] = {
      {"down: x before z", {0, -1, 0}, {0, 1, 0}, {0, 0, 1}},
      {"up: x before z", {0, 1, 0}, {0, 1, 0}, {0, 0, -1}},
      {"along x: y before z", {1, 0, 0}, {-2, 0, 0}, {0, 0, 1}},
      {"along z: x before y", {0, 0, -1}, {0, 0, 1}, {0, -1, 0}},
      {"no up at all", {0, -1, 0}, {0, 0, 0}, {0, 0, 1}},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    Camera camera = straight();
    camera.target = row.target;
    camera.up = row.up;
    const auto aside = [&](const glm::dvec3& way) {
      const glm::dvec3 place = 4.0 * row.target + 6.0 * way;
      return visible_depths(camera, 3, box(place - 0.1, place + 0.1)).has_value();
    };
    CHECK(aside(row.right));
    CHECK_FALSE(aside(glm::cross(row.right, row.target)));
  }
}

TEST_CASE("near and far fit the scene and stay within the camera's range", "[depth_range]") {
  const Box3 boxes[] = {box({-1, -1, -6}, {1, 1, -4}), box({-1, -1, -30}, {1, 1, -20}), Box3{}};
  const Camera fitted = fit_depth(straight(), 2, boxes);
  CHECK(fitted.near < 4);
  CHECK(fitted.near == Approx(4).epsilon(1e-4));  // widened by 1e-5 and what floats round
  CHECK(fitted.far > 30);
  CHECK(fitted.far == Approx(30).epsilon(1e-4));
  CHECK(fitted.eye == straight().eye);
  CHECK(fitted.fov_y == straight().fov_y);

  Camera narrow = straight();
  narrow.near = 5, narrow.far = 25;  // cuts both boxes
  CHECK(fit_depth(narrow, 2, boxes).near == 5);
  CHECK(fit_depth(narrow, 2, boxes).far == 25);

  narrow.near = 7, narrow.far = 15;  // sees neither: there is nothing to fit
  CHECK(fit_depth(narrow, 2, boxes).near == 7);
  CHECK(fit_depth(narrow, 2, boxes).far == 15);
  CHECK(fit_depth(straight(), 2, {}).near == straight().near);

  const Box3 around[] = {box({-50, -50, -50}, {50, 50, 50})};
  CHECK(fit_depth(straight(), 2, around).near == straight().near);
  CHECK(fit_depth(straight(), 2, around).far == Approx(50).epsilon(1e-4));
}

TEST_CASE("a node's box contains its mesh in world space", "[depth_range]") {
  Scene scene;
  const int group = add_node(scene, {.translation = {1e6, 0, 0}});
  add_material(scene, {});
  add_object(scene, make_box({.size = glm::vec3(2)}), 0,
             {.parent = group, .translation = {0.25, 0, 0}, .scale = {1, 2, -3}});
  const std::vector<Box3> boxes = node_boxes(scene);
  REQUIRE(boxes.size() == 2);
  CHECK(boxes[0].empty());
  // Widened by 6 units in the last place of a million.
  const double slack = 6 * 1.2e-7 * (1e6 + 1.25);
  for (int axis = 0; axis < 3; ++axis) {
    CHECK(boxes[1].low[axis] == Approx(glm::dvec3(1e6 - 0.75, -2, -3)[axis] - slack).margin(1e-9));
    CHECK(boxes[1].high[axis] == Approx(glm::dvec3(1e6 + 1.25, 2, 3)[axis] + slack).margin(1e-9));
  }
}

TEST_CASE("points displaced by rounding are within their node's box and the planes", "[depth_range]") {
  // The two translations make 0.3 m; in floats, whose steps are 6 cm at a million metres, 0.3125 m.
  Scene scene;
  const int root = add_node(scene, {.translation = {0, 0, 1e6}});
  add_material(scene, {});
  add_object(scene, make_box({.size = glm::vec3(2)}), 0, {.parent = root, .translation = {0, 0, -999999.7}});
  const double drawn = double(1e6f + -999999.7f) + 1;  // the near side
  REQUIRE(drawn == 1.3125);
  REQUIRE(bounds(scene).high.z == Approx(1.3).margin(1e-6));  // its own place
  const std::vector<Box3> boxes = node_boxes(scene);
  CHECK(boxes[1].high.z > drawn);
  CHECK(boxes[1].low.z < 0.3 - 1);
  Camera camera = straight();
  camera.eye = {0, 0, 4};
  camera.target = {0, 0, 0};
  const Camera fitted = fit_depth(camera, 1, boxes);
  CHECK(double(fitted.near) < 4 - drawn);
  CHECK(fitted.near > 4 - 1.3f - 0.75f);  // 0.72 m are in doubt: 6 units in the last place of a million
}
