// Culling by beams changes no result: shadows equal those of a ray to every sample.
#include <glm/gtc/matrix_transform.hpp>

#include "catch.hpp"
#include "pieces.hpp"

namespace atelier::test {
namespace {

using oracle::Shadows;
using oracle::World;

/// A floor, a teapot, a heap of small triangles that point everywhere, and one shape of each kind.
Scene crowded_scene() {
  Scene scene = dark_scene();
  scene.materials[0].two_sided = true;
  add_object(scene, make_plane({.width = 8, .depth = 8}), 0);
  add_object(scene, make_teapot({.height = 0.8f, .subdivisions = 4}), 0, {.translation = {-0.5, 0, 0.5}});
  add_object(scene, make_box({.size = glm::vec3(0.5f)}), 0, {.translation = {1.2, 0.25, -0.3}, .rotation_angle = 0.4f});
  Dice dice;
  Mesh mesh{.name = "confetti"};
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 middle = dice.in_cube() * glm::dvec3(2, 0.5, 2) + glm::dvec3(0, 1.5, 0);
    for (int corner = 0; corner < 3; ++corner) {
      mesh.indices.push_back(std::uint32_t(mesh.vertices.size()));
      mesh.vertices.push_back({glm::vec3(middle + 0.15 * dice.in_cube()), {0, 1, 0}, {0, 0}});
    }
  }
  add_object(scene, mesh, 0);
  return scene;
}

/// Hills and valleys, `texels` a side.
std::shared_ptr<const Texture> rough_heights(int texels) {
  Texture heights{.name = "rough", .pixels = Image(texels, texels)};
  Dice dice;
  for (Rgba& pixel : heights.pixels.pixels()) pixel.r = float(dice.next());
  return std::make_shared<const Texture>(std::move(heights));
}

std::vector<oracle::Shape> one_of_each() {
  const auto at = [](const glm::dvec3& position) { return glm::translate(glm::dmat4(1), position); };
  return {{.surface = oracle::Sphere{0.3}, .object_to_world = at({0.5, 0.6, 1})},
          {.surface = oracle::CylinderWall{.radius = 0.2, .height = 0.7}, .object_to_world = at({-1, 0.1, -1})},
          {.surface = oracle::Rectangle{.half_u = {0.4, 0, 0.2}, .half_v = {-0.1, 0.3, 0.2}},
           .object_to_world = at({0.2, 1, -0.8})},
          {.surface = oracle::HeightField{.flat = {.half_u = {0.5, 0, 0.2}, .half_v = {-0.2, 0, 0.5}},
                                          .heights = rough_heights(8),
                                          .depth = 0.5},
           .object_to_world = at({-0.6, 1.2, 0.9})}};
}

/// From the point to sample (column, row) of n x n on the light, by the words of oracle/shadow.hpp and glm's lookAt.
glm::dvec3 way_to_sample(const glm::dvec3& point, const Light& light, double width, int n, int column, int row) {
  const glm::dvec3 to_light = light.position - point, direction(light.direction);
  const glm::dvec3 ahead = light.type == LightType::point ? -to_light : direction;
  const glm::dmat4 view = glm::lookAt(glm::dvec3(0), ahead, glm::dvec3(0, 1, 0));
  const glm::dvec3 right(view[0][0], view[1][0], view[2][0]), up(view[0][1], view[1][1], view[2][1]);
  const glm::dvec3 aside = ((column + 0.5) / n - 0.5) * width * right + ((row + 0.5) / n - 0.5) * width * up;
  return light.type == LightType::directional ? -(glm::normalize(direction) + aside) : to_light + aside;
}

double visibility_ray_by_ray(const World& world, const oracle::SurfacePoint& point, const Light& light, double width,
                             int n) {
  int seen = 0;
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column) {
      const glm::dvec3 way = way_to_sample(point.position, light, width, n, column, row);
      const double most = light.type == LightType::directional ? std::numeric_limits<double>::infinity() : 1;
      const glm::dvec3 to_centre =
          light.type == LightType::directional ? -glm::dvec3(light.direction) : light.position - point.position;
      const double side = glm::dot(to_centre, point.flat_normal) < 0 ? -1e-10 : 1e-10;
      seen += !world.blocked({point.position + side * point.flat_normal, way, 0, most});
    }
  return seen / (double(n) * n);
}

}  // namespace

TEST_CASE("shadows equal those of a ray to every sample", "[shadow]") {
  const Scene scene = crowded_scene();
  const World world(scene, one_of_each());
  Dice dice;
  int dark = 0, between = 0, lit = 0;
  for (int i = 0; i < 600; ++i) {
    const auto point = world.seen({{6 * dice.next() - 3, 5, 6 * dice.next() - 3}, {0, -1, 0}});
    if (!point) continue;
    const Light light{.type = LightType(i % 3),
                      .position = dice.in_cube() * glm::dvec3(3, 1.5, 3) + glm::dvec3(0, 2, 0),
                      .direction = glm::vec3(glm::normalize(dice.in_cube() - glm::dvec3(0, 1.2, 0)))};
    const double width = std::pow(10, -3 * dice.next());  // 1 mm to 1 m, or a whole sky
    const int n = 2 + i % 15;
    INFO("point " << i << ", light " << int(light.type) << ", " << width << " wide, " << n << " samples");
    const double found =
        oracle::visibility(world, *point, light, {.shadows = Shadows::soft, .light_width = width, .light_samples = n});
    CHECK(found == visibility_ray_by_ray(world, *point, light, width, n));
    ++(found == 0 ? dark : found == 1 ? lit : between);
  }
  CHECK((dark > 50 && between > 100 && lit > 50));
}

TEST_CASE("a beam culls faces beside, behind and beyond it", "[shadow]") {
  // From the origin up to a square of 1 m at y = 4: at half way it is half as wide.
  const oracle::Window window{.frame = {.right = {1, 0, 0}, .up = {0, 0, -1}, .ahead = {0, -1, 0}},
                              .middle = {0, 4, 0}};
  oracle::Window sky = window;
  sky.endless = true;
  const struct {
    const char* name;
    glm::dvec3 middle;
    bool missed, missed_by_sky;
  } rows[] = {
      {"in the middle", {0, 2, 0}, false, false},  {"just within a side", {0.25, 2, 0}, false, false},
      {"beside it", {0.5, 2, 0}, true, true},      {"before it", {0, 2, -0.5}, true, true},
      {"behind the apex", {0, -1, 0}, true, true}, {"within the end", {0, 3.9, 0}, false, false},
      {"beyond the end", {0, 5, 0}, true, false},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    Scene scene = dark_scene();
    add_object(scene, make_box({.size = glm::vec3(0.2f)}), 0, {.translation = row.middle});
    const World world(scene);
    const auto left = [&](const oracle::Window& seen) {
      return world.casters_in(oracle::Beam({0, 0, 0}, seen, glm::dvec2(-0.5), glm::dvec2(0.5), 1e-11)).size();
    };
    CHECK((left(window) == 0) == row.missed);
    CHECK((left(sky) == 0) == row.missed_by_sky);
  }
}

TEST_CASE("a beam culls faces that no single side excludes", "[shadow]") {
  const oracle::Window window{.frame = {.right = {1, 0, 0}, .up = {0, 0, -1}, .ahead = {0, -1, 0}},
                              .middle = {0, 4, 0}};
  const struct {
    const char* name;
    glm::dvec3 corners[3];
    bool missed;
  } rows[] = {
      // At y = 2 the beam reaches to 0.25 m along x and z.
      {"level, cut off before the beam's corner", {{0.6, 2, 0}, {0, 2, 0.6}, {0.6, 2, 0.6}}, true},
      {"level, reaches over the beam's corner", {{0.4, 2, 0}, {0, 2, 0.4}, {0.4, 2, 0.4}}, false},
      {"upright, cut off before the beam's corner", {{0.6, 1.5, 0}, {0, 1.5, 0.6}, {0.8, 3, 0.8}}, true},
      {"slanting, beyond the end but for a far corner", {{-9, 3.6, -9}, {9, 5.4, -9}, {0, 4.5, 9}}, true},
      {"slanting, its plane cuts the beam below the end", {{-9, 3.5, -9}, {9, 4, -9}, {0, 4, 9}}, false},
      {"slanting, below the apex", {{-9, -0.1, -9}, {9, -2, -9}, {0, -2, 9}}, true},
  };
  for (const auto& row : rows)
    for (const bool turned : {false, true}) {
      INFO(row.name << (turned ? ", the other way round" : ""));
      const glm::dvec3 corners[] = {row.corners[0], row.corners[turned ? 2 : 1], row.corners[turned ? 1 : 2]};
      const oracle::Beam beam({0, 0, 0}, window, glm::dvec2(-0.5), glm::dvec2(0.5), 1e-11);
      CHECK(beam.misses(corners) == row.missed);
    }
}

TEST_CASE("a beam culls the floor that it starts on", "[shadow]") {
  Scene scene = dark_scene();
  add_object(scene, make_plane({.width = 100, .depth = 100}), 0, {.rotation_axis = {1, 0, 2}, .rotation_angle = 0.3f});
  const World world(scene);
  const oracle::Window window{.frame = oracle::view_frame({0, -1, 0}, {0, 1, 0}), .middle = {0, 4, 0}};
  const double gap = 1e-10;  // what shadow rays start off a floor of 100 m
  const glm::dvec3 normal = glm::normalize(glm::dvec3(
      glm::rotate(glm::dmat4(1), double(scene.nodes[0].rotation_angle), glm::dvec3(1, 0, 2)) * glm::dvec4(0, 1, 0, 0)));
  const auto left = [&](const glm::dvec3& apex) {
    return world.casters_in(oracle::Beam(apex, window, glm::dvec2(-0.5), glm::dvec2(0.5), gap)).size();
  };
  CHECK(left(gap * normal) == 0);
  CHECK(left(-gap * normal) > 0);
}

}  // namespace atelier::test
