// Height fields against planes, meshes, and marching in small steps.
#include <glm/gtc/matrix_transform.hpp>

#include "catch.hpp"
#include "pieces.hpp"
#include "scene/relief.hpp"

namespace atelier::test {
namespace {

using oracle::HeightField;
using oracle::Ray;
using oracle::Rectangle;
using oracle::Surface;

using Heights = std::shared_ptr<const Texture>;

Heights heights_of(Image pixels, Wrap wrap = Wrap::repeat) {
  return std::make_shared<const Texture>(Texture{"heights", std::move(pixels), wrap, Filter::linear});
}

/// Height(column, row), row 0 at the bottom.
template <class Height>
Heights heights(int width, int height, Wrap wrap, const Height& of) {
  Image pixels(width, height);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      pixels.at(column, height - 1 - row) = {float(of(column, row)), 0.3f, 0.7f, 1};
  return heights_of(std::move(pixels), wrap);
}

Heights random_heights(int width, int height, Wrap wrap) {
  Dice dice;
  return heights(width, height, wrap, [&](int, int) { return dice.next(); });
}

/// One high texel in the middle of a deep field.
Heights spike() {
  return heights(9, 9, Wrap::repeat, [](int column, int row) { return column == 4 && row == 4; });
}

const Rectangle square{.half_u = {1, 0, 0}, .half_v = {0, 0, -1}};
const Rectangle turned{.centre = {0.3, -0.2, 0.5}, .half_u = {0.8, 0.6, 0}, .half_v = {-0.9, 1.2, 2}};

glm::dvec3 front_of(const Rectangle& flat) {
  return glm::normalize(glm::cross(flat.half_u, flat.half_v));
}

/// (a, b) of a point over the rectangle.
glm::dvec2 over(const Rectangle& flat, const glm::dvec3& p) {
  const glm::dvec3 from = p - flat.centre;
  return {glm::dot(from, flat.half_u) / glm::dot(flat.half_u, flat.half_u),
          glm::dot(from, flat.half_v) / glm::dot(flat.half_v, flat.half_v)};
}

glm::dvec2 texcoord_at(const HeightField& field, const glm::dvec3& p) {
  return (over(field.flat, p) + 1.0) / 2.0 * field.repeat;
}

/// Metres from the surface up to a point.
double above(const HeightField& field, const glm::dvec3& p) {
  const double height = oracle::texel_colour(*field.heights, texcoord_at(field, p)).r;
  return glm::dot(p - field.flat.centre, front_of(field.flat)) + field.depth * (1 - height);
}

/// A point of the slab, and a little beside it.
glm::dvec3 in_slab(const HeightField& field, Dice& dice) {
  return field.flat.centre + 1.05 * (2 * dice.next() - 1) * field.flat.half_u +
         1.05 * (2 * dice.next() - 1) * field.flat.half_v - 1.05 * dice.next() * field.depth * front_of(field.flat);
}

glm::dvec3 somewhere(Dice& dice) {
  return 4.0 * glm::normalize(dice.in_cube());
}

struct Step {
  double from, to;  ///< t
};
/// The first of many steps over the rectangle that passes from one side to the other; from above only with
/// `front_only`. The ray must have an end.
std::optional<Step> marched(const HeightField& field, const Ray& ray, bool front_only, int steps) {
  const glm::dvec3 front = front_of(field.flat);
  const auto z = [&](double t) { return glm::dot(ray.at(t) - field.flat.centre, front); };
  const glm::dvec3 first(over(field.flat, ray.at(ray.least)), z(ray.least)),
      last(over(field.flat, ray.at(ray.most)), z(ray.most));
  double before = 0;
  bool known = false;
  for (int i = 0; i <= steps; ++i) {
    const double way = double(i) / steps;
    const glm::dvec3 at = first + way * (last - first);
    if (std::abs(at.x) > 1 || std::abs(at.y) > 1 || at.z > 0.01 * field.depth || at.z < -1.01 * field.depth) {
      known = false;
      continue;
    }
    const glm::dvec2 texcoord = (glm::dvec2(at) + 1.0) / 2.0 * field.repeat;
    const double now = at.z + field.depth * (1 - oracle::texel_colour(*field.heights, texcoord).r);
    const auto t_of = [&](int step) { return ray.least + (ray.most - ray.least) * step / steps; };
    if (known && ((before > 0 && now < 0) || (!front_only && before < 0 && now > 0))) return Step{t_of(i - 1), t_of(i)};
    before = now;
    known = true;
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("a height field of one height is its rectangle, at its depth", "[height]") {
  for (const Rectangle& flat : {square, turned})
    for (const float height : {1.0f, 0.25f, 0.0f})
      for (const double depth : {0.0, 0.4}) {
        INFO("height " << height << ", depth " << depth);
        const HeightField field{flat, heights_of(Image(3, 2, {height, 0, 0, 1})), depth};
        Rectangle lower = flat;
        lower.centre -= depth * (1 - height) * front_of(flat);
        Dice dice;
        int met = 0;
        for (int i = 0; i < 4000; ++i) {
          const glm::dvec3 from = somewhere(dice);
          const Ray ray{from, 2.0 * dice.in_cube() - from};
          const bool front_only = i % 2 == 0;
          const auto hit = oracle::intersect(Surface(field), ray, front_only),
                     expected = oracle::intersect(Surface(lower), ray, front_only);
          REQUIRE(hit.has_value() == expected.has_value());
          if (!hit) continue;
          ++met;
          CHECK(std::abs(hit->t - expected->t) < 1e-12 * std::max(1.0, expected->t));
          CHECK(glm::length(hit->normal - expected->normal) < 1e-15);
          CHECK(glm::length(hit->texcoord - expected->texcoord) < 1e-11);
        }
        CHECK(met > 400);
      }
}

TEST_CASE("a ramp is a plane", "[height]") {
  // From h = 0 at the left edge's texel centres to 1 at the right: y = (x - 8/9) rise.
  const auto ramp = heights(9, 9, Wrap::clamp_to_edge, [](int column, int) { return column / 8.0; });
  const double depth = 0.5, rise = depth * 9 / 16;
  const glm::dvec3 normal = glm::normalize(glm::dvec3(-rise, 1, 0));
  Dice dice;
  int met = 0;
  for (int i = 0; i < 4000; ++i) {
    const glm::dvec3 at(1.7 * dice.next() - 0.85, 0, 1.9 * dice.next() - 0.95);
    const glm::dvec3 on_plane(at.x, (at.x - 8.0 / 9) * rise, at.z);
    // 1e-5 off the plane's own direction, the ray is nearly parallel to it.
    glm::dvec3 way = dice.in_cube();
    way += (std::pow(10, -5 * dice.next()) - 1) * glm::dot(way, normal) * normal;
    const double from = 0.05 + dice.next();
    const Ray ray{on_plane - from * way, way};
    const auto hit = oracle::intersect(Surface(HeightField{square, ramp, depth}), ray, false);
    const double slope = std::abs(glm::dot(normal, way));
    if (!hit) continue;
    if (hit->t < from - 1e-9 / slope) continue;  // the level strips at the edges hide it
    ++met;
    CHECK(std::abs(hit->t - from) < 1e-14 / slope);
    CHECK(glm::length(hit->normal - normal) < 1e-14);
  }
  CHECK(met > 3500);
}

TEST_CASE("a height field approaches a smooth relief with the square of the texel", "[height]") {
  const DimpleShape dimples{.dimples = 2, .depth = 0.04f};
  const double depth = 2.0 * dimples.depth;
  Scene scene = dark_scene();
  Mesh mesh = make_plane({.width = 2, .depth = 2, .columns = 400, .rows = 400});
  for (Vertex& vertex : mesh.vertices)
    vertex.position.y = float(depth * (dimples_at(dimples, vertex.texcoord.x, vertex.texcoord.y).x - 1));
  add_object(scene, mesh, 0);
  const oracle::World fine(scene);
  double most[2] = {0, 0};
  for (const int finer : {0, 1}) {
    DimpleShape shape = dimples;
    shape.size = finer ? 256 : 64;
    const HeightField field{square, heights_of(make_dimples(shape).height), depth};
    Dice dice;
    for (int i = 0; i < 3000; ++i) {
      // Steeper than the relief, so that no ray passes a rim.
      const glm::dvec3 to(1.9 * dice.next() - 0.95, -0.5 * depth, 1.9 * dice.next() - 0.95);
      const glm::dvec3 way = glm::normalize(glm::dvec3(dice.next() - 0.5, -0.8, dice.next() - 0.5));
      const Ray ray{to - way, way};
      const auto hit = oracle::intersect(Surface(field), ray, true);
      const auto seen = fine.seen(ray);
      REQUIRE((hit && seen));
      most[finer] = std::max(most[finer], std::abs(hit->t - seen->t));
      if (finer) CHECK(glm::length(hit->normal - seen->flat_normal) < 0.05);
    }
  }
  INFO("largest differences " << most[0] << " and " << most[1] << " m");
  // Both second derivatives are at most 2.4 per metre: 2 * 2.4 / 8 cell^2 below the ray, 1.6 times that along it.
  CHECK(most[0] < 2.0 / 64 * 2.0 / 64);
  CHECK(most[0] > 10 * most[1]);
}

TEST_CASE("no ray passes a height field", "[height]") {
  const struct {
    const char* name;
    HeightField field;
  } rows[] = {
      {"spike", {square, spike(), 1}},
      {"spike, turned", {turned, spike(), 0.7}},
      {"random", {square, random_heights(16, 16, Wrap::repeat), 0.3}},
      {"not square, seams", {turned, random_heights(5, 3, Wrap::repeat), 0.5, {2.5, 1.3}}},
      {"mirrored", {square, random_heights(3, 4, Wrap::mirrored_repeat), 0.5, {2.5, 3}}},
      {"clamped", {square, random_heights(4, 2, Wrap::clamp_to_edge), 0.5, {1.5, 2}}},
      {"one texel", {square, random_heights(1, 1, Wrap::repeat), 0.5}},
      {"two by two", {square, random_heights(2, 2, Wrap::repeat), 0.8}},
      {"a row", {square, random_heights(7, 1, Wrap::repeat), 0.5}},
  };
  // With 100000 steps every hit lies in the first step that was found, and none is missed.
  constexpr int rays = 2000, steps = 300;
  for (const auto& row : rows) {
    INFO(row.name);
    const Box3 box = oracle::bounds({.surface = row.field});
    Dice dice;
    int met = 0, missed = 0, outside = 0;
    double off = 0, unlike = 0;
    for (int i = 0; i < rays; ++i) {
      // From afar, or within the slab; every fourth nearly along the plane.
      const glm::dvec3 to = in_slab(row.field, dice);
      glm::dvec3 from = i % 3 == 0 ? in_slab(row.field, dice) : somewhere(dice);
      const glm::dvec3 up = front_of(row.field.flat);
      if (i % 4 == 0) from -= (1 - 1e-3) * glm::dot(from - to, up) * up;
      const Ray ray{from, to - from, 0, 1};
      const bool front_only = i % 2 == 0;
      const auto hit = oracle::intersect(Surface(row.field), ray, front_only);
      const auto step = marched(row.field, ray, front_only, steps);
      if (step && !(hit && hit->t <= step->to + 1e-12)) ++missed;
      if (!hit) continue;
      ++met;
      const glm::dvec3 at = ray.at(hit->t);
      off = std::max(off, std::abs(above(row.field, at)));
      unlike = std::max(
          {unlike, glm::length(hit->texcoord - texcoord_at(row.field, at)), std::abs(glm::length(hit->normal) - 1)});
      outside += glm::any(glm::lessThan(at, box.low)) || glm::any(glm::greaterThan(at, box.high));
      if (front_only) CHECK(glm::dot(hit->normal, ray.direction) < 1e-12);
    }
    INFO(met << " of " << rays << " rays met, off by " << off << " m, texcoords by " << unlike);
    CHECK(missed == 0);
    CHECK(outside == 0);
    CHECK(met > 200);
    CHECK(off < 1e-13);  // heights times the rounding of a texture coordinate and of t
    CHECK(unlike < 1e-13);
  }
}

TEST_CASE("rays along cell borders and through texel centres", "[height]") {
  // 4 texels over 2 m: centres at -0.75, -0.25, 0.25, 0.75. The spike at (0.25, 0.25) is exactly met at its top.
  const auto peak = heights(4, 4, Wrap::repeat, [](int column, int row) { return column == 2 && row == 2; });
  const Surface field = HeightField{square, peak, 1};
  const auto t_of = [&](const glm::dvec3& from, const glm::dvec3& way, bool front_only = false) {
    const auto hit = oracle::intersect(field, {from, way}, front_only);
    return hit ? hit->t : -1;
  };
  CHECK(t_of({0.25, 2, -0.25}, {0, -1, 0}) == 2);         // its top
  CHECK(t_of({0, 2, -0.25}, {0, -1, 0}) == 2.5);          // half way down its ridge
  CHECK(t_of({0.25, -2, -0.25}, {0, 1, 0}) == 2);         // from below
  CHECK(t_of({0.25, -2, -0.25}, {0, 1, 0}, true) == -1);  // which is its back
  CHECK(t_of({-1, -0.5, -0.25}, {1, 0, 0}) == 1);         // level, along a border
  CHECK(t_of({-1, -0.5, -0.25}, {1, 0, 0}, true) == 1);
  CHECK(t_of({1, -0.5, -0.25}, {-1, 0, 0}) == 0.5);  // the other way
  CHECK(t_of({0.25, -0.5, 1}, {0, 0, -1}) == 1);     // along a column
  CHECK(t_of({0.25, -0.5, -1}, {0, 0, 1}) == 0.5);
  CHECK(t_of({-1, -0.5, 1}, {1, 0, -1}) == Approx(1.25 - 0.5 * (1 - std::sqrt(0.5))).epsilon(1e-15));  // diagonal: pq
  CHECK(t_of({-1, 0.01, -0.25}, {1, 0, 0}) == -1);                                                     // above all
  CHECK(t_of({-1, -1.01, -0.25}, {1, 0, 0}) == -1);                                                    // below all
  CHECK(t_of({-1, -1, 0.9}, {1, 0, 0}) == -1);  // within the level ground
  CHECK(t_of({-3, 2, 0.5}, {1, -1, 0}) == 3);   // onto the edge of the ground
  const double nan = std::nan("");
  CHECK(t_of({nan, 2, 0}, {0, -1, 0}) == -1);
  CHECK(t_of({0, 2, 0}, {0, nan, 0}) == -1);
  CHECK(t_of({0, 2, 0}, {0, -1e-320, 0}) == -1);
  CHECK(t_of({0.25, 2e9, -0.25}, {0, -1e9, 0}) == 2);
  CHECK(t_of({0, -0.75, -0.25}, {1e-9, 0, 0}, true) == -1);  // starts within the spike: only its back is left

  // The interval is closed, and decides which of several counts.
  const auto within = [&](double least, double most, bool front_only) {
    const auto hit = oracle::intersect(field, {{-1, -0.5, -0.25}, {1, 0, 0}, least, most}, front_only);
    return hit ? hit->t : -1;
  };
  CHECK(within(1, 1.2, true) == 1);
  CHECK(within(0, 1, true) == 1);
  CHECK(within(0, 0.999, false) == -1);
  CHECK(within(1.001, 2, true) == -1);
  CHECK(within(1.001, 2, false) == 1.5);
}

TEST_CASE("a height field repeats over its seams", "[height]") {
  // Repeated three times, it is the field whose texture is three times as wide.
  const auto once = random_heights(4, 3, Wrap::repeat);
  const auto thrice =
      heights(12, 3, Wrap::repeat, [&](int column, int row) { return once->pixels.at(column % 4, 2 - row).r; });
  const HeightField a{turned, once, 0.4, {3, 1}}, b{turned, thrice, 0.4};
  Dice dice;
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 from = somewhere(dice);
    const Ray ray{from, in_slab(a, dice) - from};
    const auto one = oracle::intersect(Surface(a), ray, false), other = oracle::intersect(Surface(b), ray, false);
    REQUIRE(one.has_value() == other.has_value());
    if (!one) continue;
    ++met;
    CHECK(std::abs(one->t - other->t) < 1e-12);
    CHECK(glm::length(one->texcoord / glm::dvec2(3, 1) - other->texcoord) < 1e-12);
  }
  CHECK(met > 1000);
}

TEST_CASE("without edges a height field goes on behind its sides", "[height]") {
  const auto random = random_heights(4, 4, Wrap::repeat);
  const HeightField window{square, random, 0.5, {1, 1}, false}, edged{square, random, 0.5};
  Rectangle large = square;
  large.half_u *= 3.0, large.half_v *= 3.0;
  const HeightField wide{large, random, 0.5, {3, 3}};  // the same relief, shifted by whole textures
  Dice dice;
  int beyond = 0;
  for (int i = 0; i < 3000; ++i) {
    const glm::dvec3 entry(2 * dice.next() - 1, 0, 2 * dice.next() - 1), way = dice.in_cube() - glm::dvec3(0, 1.1, 0);
    const Ray ray{entry - 2.0 * way, way};
    const auto seen = oracle::intersect(Surface(window), ray, true), cut = oracle::intersect(Surface(edged), ray, true),
               all = oracle::intersect(Surface(wide), ray, true);
    if (all && glm::all(glm::lessThanEqual(glm::abs(over(square, ray.at(all->t))), glm::dvec2(3)))) {
      REQUIRE(seen);
      CHECK(std::abs(seen->t - all->t) < 1e-12);
    }
    if (cut) CHECK((seen && std::abs(seen->t - cut->t) < 1e-13));
    beyond += seen && !cut;
  }
  CHECK(beyond > 100);
  const auto of = [](const HeightField& field, const glm::dvec3& from, const glm::dvec3& way) {
    return oracle::intersect(Surface(field), {from, way}, true).has_value();
  };
  CHECK_FALSE(of(window, {1.1, 1, 0}, {0, -1, 0}));  // beside it
  // A ray nearly along the plane ends after a bounded walk.
  CHECK_FALSE(oracle::intersect(Surface(HeightField{square, heights_of(Image(2, 2)), 0.5, {1, 1}, false}),
                                {{0, -0.25, 0}, {1, 0, 0}}, true));
}

TEST_CASE("a ridge blocks light, a level field does not block its own", "[height]") {
  const Scene scene = dark_scene();
  const auto ridge = heights(9, 9, Wrap::repeat, [](int column, int) { return column == 4; });
  const oracle::World world(scene, {{.surface = HeightField{square, ridge, 0.5}}});
  const auto left = world.seen({{-0.6, 1, 0.1}, {0, -1, 0}}), right = world.seen({{0.6, 1, -0.2}, {0, -1, 0}});
  REQUIRE((left && right));
  CHECK(left->position.y == -0.5);
  CHECK(world.blocked({left->position, right->position - left->position + glm::dvec3(0, 0.3, 0), 1e-9, 1}));
  CHECK(world.blocked({left->position + glm::dvec3(0, 0.4, 0), right->position - left->position, 0, 1}));
  CHECK_FALSE(world.blocked({left->position + glm::dvec3(0, 0.51, 0), right->position - left->position, 0, 1}));
  Light light{.type = LightType::point, .position = {0.6, -0.2, 0.1}};
  for (const double y : {-0.2, 0.4}) {
    light.position.y = y;
    const bool lit = y > 0;  // from (-0.6, -0.5) the way to (0.6, 0.4) passes x = 0 at y = -0.05, and the top is at 0
    CHECK(oracle::visibility(world, *left, light, {.shadows = oracle::Shadows::hard}) == 0);
    CHECK(oracle::visibility(world, *right, light, {.shadows = oracle::Shadows::hard}) == 1);
    light.position.y = y + 1;
    if (lit) CHECK(oracle::visibility(world, *left, light, {.shadows = oracle::Shadows::hard}) == 1);
  }

  // No shadow acne: on a convex part, every point sees a light above its horizon.
  const auto hill = heights(64, 64, Wrap::clamp_to_edge, [](int column, int row) {
    const double x = (column - 31.5) / 32, y = (row - 31.5) / 32;
    return 1 - 0.5 * (x * x + y * y);
  });
  const oracle::World hills(scene, {{.surface = HeightField{turned, hill, 0.4}}});
  const glm::dvec3 up = front_of(turned);
  Dice dice;
  int dark = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 at =
        turned.centre + (1.6 * dice.next() - 0.8) * turned.half_u + (1.6 * dice.next() - 0.8) * turned.half_v;
    const auto point = hills.seen({at + up, -up});
    REQUIRE(point);
    const glm::dvec3 aside = glm::normalize(glm::cross(point->flat_normal, dice.in_cube()));
    // 3 degrees above the horizon; facets of the hill bend by 1/32 of 0.4 from one to the next.
    const glm::dvec3 way = std::cos(3 * pi / 180) * aside + std::sin(3 * pi / 180) * point->flat_normal;
    const Light sun{.type = LightType::directional, .direction = glm::vec3(-way)};
    dark += oracle::visibility(hills, *point, sun, {.shadows = oracle::Shadows::hard}) != 1;
  }
  CHECK(dark == 0);
}

TEST_CASE("a light is partly seen through a notch whose sides hide its corners", "[height]") {
  const Scene scene = dark_scene();
  const auto notched = heights(9, 9, Wrap::repeat, [](int column, int row) { return column == 4 && row != 4; });
  const oracle::World world(scene, {{.surface = HeightField{square, notched, 0.5}}, ground(1)});
  CHECK_FALSE(world.fills_between(0));
  CHECK(world.fills_between(1));
  const auto point =
      oracle::World(scene, {{.surface = HeightField{square, notched, 0.5}}}).seen({{-0.8, 1, 0}, {0, -1, 0}});
  REQUIRE(point);
  const Light light{.type = LightType::point, .position = {0.8, -0.35, 0}};
  const double seen = oracle::visibility(world, *point, light,
                                         {.shadows = oracle::Shadows::soft, .light_width = 0.3, .light_samples = 16});
  CHECK((seen > 0.1 && seen < 0.9));
}

TEST_CASE("normal maps on rectangles and height fields", "[height]") {
  const DimpleShape dimples{.size = 256, .dimples = 2, .depth = 0.04f};
  Scene mesh = dark_scene();
  mesh.materials[0].two_sided = true;
  mesh.materials[0].normal_texture = add_texture(mesh, "dimples", make_dimples(dimples).normal, Filter::linear);
  mesh.camera = map_camera(4);
  Scene empty = mesh;
  add_object(mesh, make_plane({.width = 2, .depth = 2}), 0);
  const HeightField field{square, heights_of(make_dimples(dimples).height), 2.0 * dimples.depth};
  const auto normals = [](const oracle::World& world) {
    return oracle::trace(world, {.camera = world.scene().camera,
                                 .size = {64, 64},
                                 .output = oracle::Output::normal,
                                 .shading = {.normal_maps = true}});
  };
  for (const glm::dvec3& scale : {glm::dvec3(1), glm::dvec3(-1, 1, 1), glm::dvec3(1, 1, -1), glm::dvec3(1, -1, 1)}) {
    INFO("scaled by " << scale.x << ", " << scale.y << ", " << scale.z);
    mesh.nodes[0].scale = glm::vec3(scale);
    const Image expected = normals(oracle::World(mesh));
    const glm::dmat4 place = glm::scale(glm::dmat4(1), scale);
    for (const Surface& surface : {Surface(square), Surface(field)}) {
      const Image found = normals(oracle::World(empty, {{.surface = surface, .object_to_world = place}}));
      float most = 0;
      for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
          for (const auto member : {&Rgba::r, &Rgba::g, &Rgba::b})
            most = std::max(most, std::abs(found.at(x, y).*member - expected.at(x, y).*member));
      CHECK(most < 1e-5);  // plates of a mesh are floats
    }
  }
  // Without a map, the normal is the relief's; with one, only flat_normal is.
  const Ray ray{{0.2, 1, 0.37}, {0, -1, 0}};
  const auto mapped = oracle::World(empty, {{.surface = field}}).seen(ray);
  empty.materials[0].normal_texture.reset();
  const auto plain = oracle::World(empty, {{.surface = field}}).seen(ray);
  REQUIRE((mapped && plain));
  CHECK(plain->normal == plain->flat_normal);
  CHECK(plain->tangent == glm::dvec4(0));
  CHECK(plain->normal == mapped->flat_normal);
  CHECK(plain->normal.y < 0.999);
  CHECK(mapped->normal == glm::dvec3(0, 1, 0));
  CHECK(mapped->tangent == glm::dvec4(1, 0, 0, 1));
}

TEST_CASE("a height field that is not valid is refused", "[height]") {
  const Scene scene = dark_scene();
  const auto fine = random_heights(3, 3, Wrap::repeat);
  const auto nearest =
      std::make_shared<const Texture>(Texture{.name = "steps", .pixels = Image(2, 2), .filter = Filter::nearest});
  const struct {
    const char* why;
    HeightField field;
  } rows[] = {
      {"it has no heights", {square, nullptr, 1}},
      {"it has no heights", {square, std::make_shared<const Texture>(), 1}},
      {"not interpolated", {square, nearest, 1}},
      {"contains the height 1.5", {square, heights_of(Image(2, 2, {1.5f, 0, 0, 1})), 1}},
      {"contains the height nan", {square, heights_of(Image(2, 2, {std::nanf(""), 0, 0, 1})), 1}},
      {"a depth of -1 m", {square, fine, -1}},
      {"sides are zero or not perpendicular", {{.half_u = {0, 0, 0}}, fine, 1}},
      {"sides are zero or not perpendicular", {{.half_u = {1, 0, 1}}, fine, 1}},
      {"repeated 0 times", {square, fine, 1, {1, 0}}},
      {"repeated 100000 times", {square, fine, 1, {1e5, 1}}},
  };
  for (const auto& row : rows) {
    INFO(row.why);
    std::string said;
    try {
      const oracle::World world(scene, {{.surface = row.field}});
    } catch (const Error& e) {
      said = e.what();
    }
    CHECK(said.find(row.why) != std::string::npos);
    CHECK(said.rfind("scene 'test': shape 0: height field: ", 0) == 0);
  }
}

TEST_CASE("a window shows only what is behind it", "[height_field]") {
  // Height 0 everywhere: a floor half a metre below the plane, 2 x 2 m.
  HeightField field{.flat = square, .heights = heights(1, 1, Wrap::repeat, [](int, int) { return 0; }), .depth = 0.5};
  const auto meets = [&](const glm::dvec3& from, const glm::dvec3& to) {
    return oracle::intersect(Surface(field), {from, to - from}, true).has_value();
  };
  const glm::dvec3 floor(0.9, -0.5, 0), above(0.2, 1, 0), beside(2.9, 0.5, 0), below(0.2, -0.1, 0);
  CHECK(meets(above, floor));
  CHECK(meets(beside, floor));  // passes the plane beyond the side
  field.window = true;
  CHECK(meets(above, floor));
  CHECK_FALSE(meets(beside, floor));
  CHECK(meets(below, floor));  // begins behind the window
  CHECK_FALSE(meets(above, {0.2, 2, 0}));
}

}  // namespace atelier::test
