// The sky in a direction: faces, edges and corners of the cube.
#include "scene/sky.hpp"

#include "catch.hpp"
#include "pieces.hpp"

namespace atelier::test {
namespace {

/// Each texel tells where it is: its face, column and row.
Sky labelled_sky(int edge) {
  Sky sky;
  for (std::size_t face = 0; face < sky.faces.size(); ++face) {
    sky.faces[face] = Image(edge, edge);
    for (int row = 0; row < edge; ++row)
      for (int column = 0; column < edge; ++column)
        sky.faces[face].at(column, row) = {float(face), float(column), float(row), 1};
  }
  return sky;
}

/// Random colours.
Sky speckled_sky(int edge) {
  Dice dice;
  return make_sky(edge, [&](const glm::dvec3&) { return glm::dvec3(dice.next(), dice.next(), dice.next()); });
}

glm::dvec3 texel_of(const Sky& sky, std::size_t face, int column, int row) {
  const Rgba& texel = sky.faces[face].at(column, row);
  return {texel.r, texel.g, texel.b};
}

bool same(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::distance(a, b) < 1e-12;  // a few rounding errors of numbers below 10
}

/// The colour is the direction d as d/2 + 1/2.
Sky linear_sky(int edge) {
  return make_sky(edge, [](const glm::dvec3& direction) { return direction * 0.5 + 0.5; });
}

}  // namespace

TEST_CASE("faces are those of OpenGL's cube maps", "[sky]") {
  const struct {
    const char* name;
    glm::dvec3 direction;
    double face;
  } rows[] = {
      // s = 3/4 and t = -1/4 by table 3.19 of the OpenGL 3.3 core specification: column 3 of 4, row 1.
      {"+x", {1, 0.25, -0.75}, 0}, {"-x", {-1, 0.25, 0.75}, 1}, {"+y", {0.75, 1, -0.25}, 2},
      {"-y", {0.75, -1, 0.25}, 3}, {"+z", {0.75, 0.25, 1}, 4},  {"-z", {-0.75, 0.25, -1}, 5},
  };
  const Sky sky = labelled_sky(4);
  for (const auto& row : rows) {
    INFO(row.name);
    for (const double length : {1e-3, 1.0, 1e9})
      CHECK(same(oracle::sky_colour(sky, length * row.direction), {row.face, 3, 1}));
  }
}

TEST_CASE("a sky of one colour has it in every direction", "[sky]") {
  const glm::dvec3 colour(0.25, 0.5, 8);
  for (const int edge : {1, 2, 7}) {
    const Sky sky = make_sky(edge, [&](const glm::dvec3&) { return colour; });
    Dice dice;
    for (int i = 0; i < 1000; ++i) CHECK(same(oracle::sky_colour(sky, dice.in_cube()), colour));
    for (const double x : {-1, 0, 1})
      for (const double y : {-1, 0, 1})
        for (const double z : {-1, 1}) CHECK(same(oracle::sky_colour(sky, {x, y, z}), colour));
  }
}

TEST_CASE("a smooth sky is interpolated", "[sky]") {
  constexpr int edge = 64;
  const Sky sky = linear_sky(edge);
  Dice dice;
  double inside = 0, anywhere = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 direction = dice.in_cube(), size = glm::abs(direction);
    const glm::dvec3 expected = glm::normalize(direction) * 0.5 + 0.5;
    const double error = glm::distance(oracle::sky_colour(sky, direction), expected);
    const double largest = std::max({size.x, size.y, size.z}), smallest = std::min({size.x, size.y, size.z});
    const double middle = size.x + size.y + size.z - largest - smallest;
    anywhere = std::max(anywhere, error);
    if (middle < (1 - 1.0 / edge) * largest) inside = std::max(inside, error);
  }
  // Texels are h = 1/32 apart in s and t, and both second derivatives are 1/2 at most: h^2/8 (1/2 + 1/2) = 1.2e-4.
  CHECK(inside < 2e-4);
  // At an edge half of the colour is from the other face, whose texels are up to half a texel, 1/64 in t, beside the
  // row that they continue; the slope is 1/2 at most.
  CHECK(anywhere < 0.25 / edge);
}

TEST_CASE("edges of the cube are interpolated between two faces", "[sky]") {
  const Sky sky = speckled_sky(3);
  const struct {
    const char* name;
    glm::dvec3 direction;
    std::size_t face;  ///< and column and row of the texel beside the middle of the edge
    int column, row;
    std::size_t other;
    int other_column, other_row;
  } rows[] = {
      {"+x +y", {1, 1, 0}, 0, 1, 0, 2, 2, 1},  {"+x -y", {1, -1, 0}, 0, 1, 2, 3, 2, 1},
      {"+x +z", {1, 0, 1}, 0, 0, 1, 4, 2, 1},  {"+x -z", {1, 0, -1}, 0, 2, 1, 5, 0, 1},
      {"-x +y", {-1, 1, 0}, 1, 1, 0, 2, 0, 1}, {"-x -y", {-1, -1, 0}, 1, 1, 2, 3, 0, 1},
      {"-x +z", {-1, 0, 1}, 1, 2, 1, 4, 0, 1}, {"-x -z", {-1, 0, -1}, 1, 0, 1, 5, 2, 1},
      {"+y +z", {0, 1, 1}, 2, 1, 2, 4, 1, 0},  {"+y -z", {0, 1, -1}, 2, 1, 0, 5, 1, 0},
      {"-y +z", {0, -1, 1}, 3, 1, 0, 4, 1, 2}, {"-y -z", {0, -1, -1}, 3, 1, 2, 5, 1, 2},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    const glm::dvec3 here = texel_of(sky, row.face, row.column, row.row),
                     there = texel_of(sky, row.other, row.other_column, row.other_row);
    CHECK(same(oracle::sky_colour(sky, row.direction), (here + there) / 2.0));
  }
}

TEST_CASE("at a corner of the cube three texels have the same share", "[sky]") {
  const Sky sky = speckled_sky(3);
  CHECK(same(oracle::sky_colour(sky, {1, 1, 1}),
             (texel_of(sky, 0, 0, 0) + texel_of(sky, 2, 2, 2) + texel_of(sky, 4, 2, 0)) / 3.0));
  CHECK(same(oracle::sky_colour(sky, {-1, -1, -1}),
             (texel_of(sky, 1, 0, 2) + texel_of(sky, 3, 0, 2) + texel_of(sky, 5, 2, 2)) / 3.0));
}

TEST_CASE("a sky has no seams", "[sky]") {
  for (const int edge : {1, 2, 5}) {
    const Sky sky = speckled_sky(edge);
    Dice dice;
    for (int i = 0; i < 2000; ++i) {
      glm::dvec3 direction = dice.in_cube();
      const int axis = i % 3, second = (axis + 1) % 3;  // onto the edge between two faces
      direction[axis] = i % 2 == 0 ? 1 : -1;
      direction[second] = i % 4 < 2 ? 1 : -1;
      glm::dvec3 beside = direction, beyond = direction;
      beside[axis] *= 1 + 1e-9;
      beyond[second] *= 1 + 1e-9;
      // The slope is below sqrt(3) for a texel, of which there are at most 5/2 in a unit of s: 9e-9 for a step of 2e-9.
      CHECK(glm::distance(oracle::sky_colour(sky, beside), oracle::sky_colour(sky, beyond)) < 1e-7);
    }
  }
}

TEST_CASE("rays that meet nothing have the sky's colour, in colour alone", "[sky]") {
  Scene scene = dark_scene();
  scene.background = {1, 0, 1};
  scene.sky = std::make_shared<const Sky>(speckled_sky(4));
  scene.camera = {.eye = {3, 2, 1}, .target = {-1, 3, 0.5}, .fov_y = degrees(100)};
  const oracle::World world(scene);
  const glm::ivec2 size(7, 5);
  const oracle::CameraRays camera(scene.camera, size);
  const Image seen = oracle::trace(world, {.camera = scene.camera, .size = size});
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::vec3 colour(oracle::sky_colour(*scene.sky, camera.through({x + 0.5, y + 0.5}).direction));
      CHECK(seen.at(x, y) == Rgba{colour.r, colour.g, colour.b, 1});
    }
  for (const std::string& output : oracle::output_names()) {
    if (output == "colour") continue;
    INFO(output);
    CHECK(oracle::trace(world, {.camera = scene.camera, .size = size, .output = oracle::output_named(output)}) ==
          Image(size.x, size.y, {0, 0, 0, 1}));
  }
}

TEST_CASE("through a portal and in a mirror the sky is seen in the ray's last direction", "[sky]") {
  Scene scene = dark_scene();
  scene.sky = std::make_shared<const Sky>(linear_sky(64));
  const auto corner = [](float x, float y) { return Vertex{{x, y, 0}, {0, 0, 1}, {0, 0}}; };
  const int mesh = add_mesh(scene, {.name = "opening",
                                    .vertices = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)},
                                    .indices = {0, 1, 2, 0, 2, 3}});
  const int here = add_node(scene, {.name = "here", .mesh = mesh});
  const int there = add_node(scene, {.name = "there", .translation = {20, 0, 5}, .rotation_angle = degrees(90)});
  scene.camera = {.eye = {0, 0, 2}, .target = {0, 0, 0}, .fov_y = degrees(20)};
  const glm::ivec2 size(9, 9);
  const glm::dvec3 ray = oracle::CameraRays(scene.camera, size).through({6.5, 2.5}).direction;
  const auto seen = [&](const Portal& portal) {
    scene.portals = {portal};
    const oracle::World world(scene);
    oracle::PictureRequest request{.camera = scene.camera, .size = size};
    request.shading.portal_depth = 1;
    const Rgba pixel = oracle::trace(world, request).at(6, 2);
    return glm::dvec3(pixel.r, pixel.g, pixel.b);
  };
  // Into the opening along -z and out of the exit along its +z, which is the world's +x: right of the way is +z then.
  const glm::dvec3 carried(-ray.z, ray.y, ray.x), reflected(ray.x, ray.y, -ray.z);
  const double tolerance = 2e-7;  // pixels are floats, and the quarter turn's sine is one
  CHECK(glm::distance(seen({.node = here, .exit = there}), oracle::sky_colour(*scene.sky, carried)) < tolerance);
  CHECK(glm::distance(seen({.node = here}), oracle::sky_colour(*scene.sky, reflected)) < tolerance);
}

}  // namespace atelier::test
