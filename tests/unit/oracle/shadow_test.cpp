// The visible fraction of a light, against formulas.
#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>

#include "catch.hpp"
#include "pieces.hpp"
#include "scene/builtin.hpp"

namespace atelier::test {
namespace {

using oracle::Shading;
using oracle::Shadows;
using oracle::visibility;
using oracle::World;

oracle::SurfacePoint point_at(const glm::dvec3& position, const glm::dvec3& normal = {0, 1, 0}) {
  return {.position = position, .normal = normal, .flat_normal = normal};
}

Shading soft(double width, int samples) {
  return {.shadows = Shadows::soft, .light_width = width, .light_samples = samples};
}

constexpr double high = 1e3;  ///< a blocker that reaches so far ends nowhere in these tests

/// What reaches from x = `edge` to +x at a height, the edge turned by `turn` radians around the y axis.
oracle::Shape half_plane(double height, double edge = 0, double turn = 0) {
  const glm::dmat4 turned = glm::rotate(glm::dmat4(1), turn, glm::dvec3(0, 1, 0));
  return {
      .surface = oracle::Rectangle{.centre = {edge + high, height, 0}, .half_u = {high, 0, 0}, .half_v = {0, 0, -high}},
      .object_to_world = turned};
}

Light lamp(LightType type, double height) {
  return {.type = type, .position = {0, height, 0}, .direction = {0, -1, 0}};
}

/// The share of the unit square around the origin that lies where x cos(turn) + y sin(turn) < t: the integral of a box
/// as wide as the cosine, blurred by one as wide as the sine.
double share_before(double t, double turn) {
  const double c = std::abs(std::cos(turn)), s = std::abs(std::sin(turn));
  if (s < 1e-12) return std::clamp(t + 0.5, 0.0, 1.0);
  const auto ramp = [](double x) { return x > 0 ? x * x : 0; };
  return (ramp(t + (c + s) / 2) - ramp(t + (c - s) / 2) - ramp(t - (c - s) / 2) + ramp(t - (c + s) / 2)) / (2 * c * s);
}

/// The largest difference from what is expected over points across a penumbra that lies within x = -reach .. reach.
template <class Expected>
double worst_across(const World& world, const Light& light, const Shading& shading, double reach, Expected&& expected) {
  double worst = 0;
  for (int i = 0; i <= 200; ++i) {
    const double x = (i / 100.0 - 1) * reach;
    worst = std::max(worst, std::abs(visibility(world, point_at({x, 0, 0}), light, shading) - expected(x)));
  }
  return worst;
}

}  // namespace

TEST_CASE("behind an edge the light fades as the visible part of its square", "[shadow]") {
  // The light hangs at zR = 4 m, the edge zB = 3 m below it: the penumbra is (zR - zB) / zB L wide.
  const double width = 0.6, edge_height = 1, light_height = 4;
  const double penumbra = edge_height / (light_height - edge_height) * width;
  const Scene scene = dark_scene();
  for (const double turn : {0.0, 0.3, pi / 4, 1.2}) {
    // Seen from (x, 0, 0) the edge cuts the square where x' cos + z' sin = -x cos / penumbra, in widths of the light.
    const World world(scene, {half_plane(edge_height, 0, -turn)});
    const auto expected = [&](double x) { return share_before(-x * std::cos(turn) / penumbra, turn); };
    for (const int n : {2, 8, 32, 128, 256}) {
      INFO("edge turned by " << turn << ", " << n << " x " << n << " samples");
      const double worst = worst_across(world, lamp(LightType::spot, light_height), soft(width, n), penumbra, expected);
      // Along rows of samples, or their diagonals, an edge is placed to half a sample: an error of first order. At
      // other slants the rows' errors differ and mostly cancel: at 256 samples a tenth is left at most.
      CHECK(worst <= 0.5 / n + 1e-12);
      if (turn == 0) CHECK(worst > 0.2 / n);
      if (n == 256 && (turn == 0.3 || turn == 1.2)) CHECK(worst < 2e-4);
    }
  }
}

TEST_CASE("the mean over a penumbra is better than its worst point", "[shadow]") {
  const Scene scene = dark_scene();
  const World world(scene, {half_plane(1)});
  double sum = 0;
  const int points = 1000;
  for (int i = 0; i < points; ++i) {
    const double x = ((i + 0.5) / points - 0.5) * 0.2;
    const double found = visibility(world, point_at({x, 0, 0}), lamp(LightType::spot, 4), soft(0.6, 256));
    sum += std::abs(found - (0.5 - x / 0.2));
  }
  CHECK(sum / points < 1e-3);  // half a sample at worst, a quarter on average: 1 / (4 * 256)
}

TEST_CASE("a directional light's square of directions fades behind an edge, at every angle", "[shadow]") {
  const Scene scene = dark_scene();
  const double height = 2, width = 0.05;
  const World world(scene, {half_plane(height)});
  Light sun = lamp(LightType::directional, 0);
  // Straight down: a ray leans by a, |a| <= width / 2, and passes the edge where x + a height < 0.
  CHECK(worst_across(world, sun, soft(width, 128), height * width,
                     [&](double x) { return share_before(-x / (height * width), 0); }) <= 0.5 / 128 + 1e-12);
  // Standing at x: y = 3: 4, of unit length (-0.6, -0.8, 0). Its up leans towards the light, (-0.8, 0.6, 0): the way is
  // (0.6 + 0.8 b, 0.8 - 0.6 b) in x and y, and x + height (0.6 + 0.8 b) / (0.8 - 0.6 b) < 0 gives b.
  sun.direction = {-3, -4, 0};
  CHECK(worst_across(world, sun, soft(width, 128), 2, [&](double x) {
          const double b = -(0.8 * x + 0.6 * height) / (0.8 * height - 0.6 * x);
          return share_before(b / width, 0);
        }) <= 0.5 / 128 + 1e-7);  // a light's direction is three floats: 2^-24 of a unit, over the width
}

TEST_CASE("a square before the light hides all or half of it", "[shadow]") {
  const Scene scene = dark_scene();
  const auto card = [](double middle, double half) {
    return oracle::Shape{
        .surface = oracle::Rectangle{.centre = {middle, 1, 0}, .half_u = {half, 0, 0}, .half_v = {0, 0, -half}}};
  };
  const struct {
    const char* name;
    oracle::Shape card;
    double share;
  } rows[] = {
      // From the origin the light, 0.8 m wide and 4 m high, is seen through 0.2 m at 1 m.
      {"a little larger than the light", card(0, 0.1001), 0},
      {"the edge runs through the middle", card(0.25, 0.25), 0.5},
      {"beside it", card(0.36, 0.25), 1},
      {"half as wide, half as long", card(0, 0.05), 0.75},
  };
  for (const auto& row : rows)
    for (const LightType type : {LightType::spot, LightType::point})
      for (const int n : {4, 16, 256}) {
        INFO(row.name << ", " << n << " samples, light " << int(type));
        const World world(scene, {row.card});
        CHECK(visibility(world, point_at({0, 0, 0}), lamp(type, 4), soft(0.8, n)) == row.share);
      }
}

TEST_CASE("a square light through a vertical pipe", "[shadow]") {
  // The pipe's upper rim, 0.2 m at 2 m, cuts a circle of 0.4 m out of the lamp, which is 0.8 m wide and 4 m high. All
  // four corners are hidden by the one wall, and yet the middle is seen.
  const Scene scene = dark_scene();
  glm::dmat4 place(1);
  place[3] = {0, 1, 0, 1};
  const World world(scene, {{.surface = oracle::CylinderWall{.radius = 0.2, .height = 1}, .object_to_world = place}});
  const double found = visibility(world, point_at({0, 0, 0}), lamp(LightType::spot, 4), soft(0.8, 256));
  // The number of points of a grid in a circle is off by about the cube root of the square of its radius in cells (the
  // circle problem): 25 of 65536.
  CHECK(std::abs(found - pi / 4) < 5e-4);
}

TEST_CASE("a light without extent casts hard shadows, bit for bit", "[shadow]") {
  const Scene scene = make_builtin_scene("primitives");
  const World world(scene);
  const auto picture = [&](const Shading& shading) {
    return trace(world, {.camera = scene.camera, .size = {64, 48}, .shading = shading});
  };
  const Image hard = picture({.shadows = Shadows::hard});
  CHECK(picture(soft(0, 16)) == hard);
  CHECK(picture(soft(0.3, 1)) == hard);
  CHECK_FALSE(picture(soft(0.3, 4)) == hard);
  CHECK_FALSE(picture({}) == hard);
}

TEST_CASE("surfaces without a caster, receiver or shadowing light are lit", "[shadow]") {
  const auto seen = [](auto&& change, const Shading& shading) {
    Scene scene = dark_scene();
    oracle::Shape roof = half_plane(1, -high);
    oracle::SurfacePoint point = point_at({0, 0, 0});
    Light light = lamp(LightType::spot, 4);
    add_object(scene, make_plane({.width = 10, .depth = 10}), 0, {.translation = {0, 2, 0}});
    change(scene.nodes[0], roof, point, light);
    return visibility(World(scene, {roof}), point, light, shading);
  };
  for (const Shading& shading : {Shading{.shadows = Shadows::hard}, soft(0.5, 8)}) {
    CHECK(seen([](auto&...) {}, shading) == 0);
    CHECK(seen([](Node& node, auto&...) { node.casts_shadow = false; }, shading) == 0);
    CHECK(seen([](Node&, oracle::Shape& roof, auto&...) { roof.casts_shadow = false; }, shading) == 0);
    CHECK(seen([](Node& node, oracle::Shape& roof, auto&...) { node.casts_shadow = roof.casts_shadow = false; },
               shading) == 1);
    CHECK(seen([](Node&, oracle::Shape&, auto& point, Light&) { point.receives_shadow = false; }, shading) == 1);
    CHECK(seen([](Node&, oracle::Shape&, auto&, Light& light) { light.casts_shadow = false; }, shading) == 1);
  }
  CHECK(seen([](auto&...) {}, Shading{}) == 1);
}

TEST_CASE("a fraction of each light is multiplied by its visibility", "[shadow]") {
  // A pane that halves what falls on x > 0, and lets a quarter of one light through.
  const auto pane = [](const Light& light, const glm::dvec3& position) {
    return (light.name == "dim" ? 0.25 : 1.0) * (position.x > 0 ? 0.5 : 1.0);
  };
  const Scene scene = dark_scene();
  const World world(scene, {half_plane(1, 0.25)});  // hides the lamps from x > 1/3
  Light bright = lamp(LightType::spot, 4), dim = bright;
  dim.name = "dim";
  const struct {
    const char* name;
    double x;
    const Light& light;
    Shading shading;
    double expected;
  } rows[] = {
      {"seen, beside the pane", -1, bright, {.shadows = Shadows::hard}, 1},
      {"seen through it", 0.125, bright, {.shadows = Shadows::hard}, 0.5},
      {"another light", 0.125, dim, {.shadows = Shadows::hard}, 0.125},
      {"hidden", 1, bright, {.shadows = Shadows::hard}, 0},
      {"without shadows there are panes all the same", 1, dim, {}, 0.125},
      {"half in half-shadow", 1.0 / 3, bright, soft(0.3, 16), 0.25},
  };
  for (auto row : rows) {
    INFO(row.name);
    row.shading.share = pane;
    const oracle::SurfacePoint point = point_at({row.x, 0, 0});
    CHECK(visibility(world, point, row.light, row.shading) == row.expected);
    oracle::SurfacePoint aloof = point;
    aloof.receives_shadow = false;
    CHECK(visibility(world, aloof, row.light, row.shading) == 1);
  }
  for (const double wrong : {-0.1, 1.5, std::nan("")}) {
    const Shading shading{.share = [=](const Light&, const glm::dvec3&) { return wrong; }};
    CHECK(mentions(error_of([&] {
                     visibility(world, point_at({0, 0, 0}), dim, shading);
                   }),
                   {fmt::format("share {}", wrong), "'dim'", "0 to 1"}));
  }
}

TEST_CASE("blocked light is missing from a picture, ambient light is not", "[shadow]") {
  Scene scene = dark_scene();
  scene.ambient = glm::vec3(0.25f);
  scene.lights = {lamp(LightType::directional, 0), lamp(LightType::directional, 0)};
  scene.lights[0].name = "dim";
  const World world(scene, {ground(10)});
  const Image picture = trace(
      world, {.camera = map_camera(4), .size = {4, 4}, .shading = {.share = [](const Light& light, const auto& at) {
                                                         return light.name == "dim" && at.x > 0 ? 0.5 : 1.0;
                                                       }}});
  for (int x = 0; x < 4; ++x) CHECK(picture.at(x, 1).r == (x < 2 ? 2.25f : 1.75f));
}

TEST_CASE("a light in a closed box is visible only from inside", "[shadow]") {
  Scene scene = dark_scene();
  add_object(scene, make_box({.size = glm::vec3(2)}), 0, {.rotation_axis = {1, 2, 3}, .rotation_angle = 0.7f});
  const World world(scene);
  const Light light{.position = {0.3, -0.2, 0.1}};
  Dice dice;
  for (int i = 0; i < 50; ++i) {
    const glm::dvec3 way = glm::normalize(dice.in_cube());
    for (const Shading& shading : {Shading{.shadows = Shadows::hard}, soft(0.2, 9)}) {
      CHECK(visibility(world, point_at(2.0 * way, -way), light, shading) == 0);
      CHECK(visibility(world, point_at(0.9 * way, -way), light, shading) == 1);
    }
  }
}

TEST_CASE("a light that touches a surface", "[shadow]") {
  Scene scene = dark_scene();
  add_object(scene, make_plane({.width = 8, .depth = 8}), 0);
  add_object(scene, make_plane({.width = 8, .depth = 8}), 0, {.translation = {0, 3, 0}});
  const World world(scene);
  Scene loose = scene;
  loose.nodes[0].casts_shadow = false;
  const World loose_world(loose);
  const auto spot = [](const glm::dvec3& position, const glm::vec3& direction) {
    return Light{.type = LightType::spot, .position = position, .direction = direction};
  };
  const oracle::SurfacePoint on_floor = point_at({0.7, 0, -0.4}), on_ceiling = point_at({1.1, 3, 0.2}, {0, -1, 0});
  const struct {
    const char* name;
    const World& world;
    oracle::SurfacePoint point;
    Light light;
    double hard, soft;
  } rows[] = {
      {"set into the ceiling, seen from the floor", world, on_floor, spot({0, 3, 0}, {0, -1, 0}), 1, 1},
      {"set into the ceiling, seen along it", world, on_ceiling, spot({0, 3, 0}, {0, -1, 0}), 1, 1},
      {"just above the ceiling", world, on_floor, spot({0, 3 + 1e-6, 0}, {0, -1, 0}), 0, 0},
      {"upright, halfway into the floor", world, on_floor, spot({-1, 0, 0}, {1, 0, 0}), 1, 0.5},
      {"the same, and the floor casts no shadow", loose_world, on_floor, spot({-1, 0, 0}, {1, 0, 0}), 1, 1},
      {"on the point itself", world, on_floor, spot(on_floor.position, {0, -1, 0}), 1, 1},
      {"a lamp on the point itself", world, on_floor, {.position = on_floor.position}, 1, 1},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    CHECK(visibility(row.world, row.point, row.light, {.shadows = Shadows::hard}) == row.hard);
    CHECK(visibility(row.world, row.point, row.light, soft(0.5, 16)) == row.soft);
  }
}

TEST_CASE("soft shadows out of range are refused", "[shadow]") {
  const Scene scene = dark_scene();
  const World world(scene);
  const auto refused = [&](const Shading& shading) {
    const std::string told = error_of([&] { visibility(world, point_at({0, 0, 0}), Light{}, shading); });
    CHECK(error_of([&] { trace(world, {.size = {4, 4}, .shading = shading}); }) == told);  // though nothing is seen
    return told;
  };
  CHECK(mentions(refused(soft(1, 0)), {"0 x 0 points", "256 x 256"}));
  CHECK(mentions(refused(soft(1, 257)), {"257 x 257 points"}));
  CHECK(mentions(refused(soft(-0.5, 8)), {"light -0.5 wide", "0 to 1000000"}));
  CHECK(mentions(refused(soft(std::nan(""), 8)), {"light nan wide"}));
  CHECK(mentions(refused(soft(1.1e6, 8)), {"light 1100000 wide"}));
  CHECK(mentions(refused(soft(std::numeric_limits<double>::infinity(), 8)), {"light inf wide"}));
  CHECK(refused({.shadows = Shadows::hard, .light_width = -1, .light_samples = 0}).empty());
  CHECK(refused(soft(0, 256)).empty());
}

TEST_CASE("a picture of the visibility of one light", "[shadow]") {
  Scene scene = dark_scene();
  scene.lights = {lamp(LightType::spot, 4)};
  scene.background = {1, 1, 1};
  const World world(scene, {ground(10), half_plane(1)});
  const Shading shading = soft(0.6, 64);
  const int pixels = 40;
  Camera camera = map_camera(1);
  camera.eye.y = 0.9;  // below the edge
  camera.near = 0.1f;
  const Image factor = trace(
      world, {.camera = camera, .size = {pixels, pixels}, .shading = {.surface = [&](auto& in, auto& point, auto&) {
                                                            return glm::dvec3(
                                                                visibility(in, point, in.scene().lights[0], shading));
                                                          }}});
  double worst = 0;
  for (int y = 0; y < pixels; ++y)
    for (int x = 0; x < pixels; ++x) {
      const double expected = share_before(-on_map(x, y, pixels, 1).x / 0.2, 0);
      worst = std::max(worst, std::abs(factor.at(x, y).r - expected));
    }
  CHECK(worst <= 0.5 / 64 + 1e-6);  // half a row of samples; the picture holds floats
}

}  // namespace atelier::test
