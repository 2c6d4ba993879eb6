// Procedural skies: where their texels look, and what they show there.
#include "scene/sky.hpp"

#include <algorithm>

#include "catch.hpp"

using namespace atelier;

namespace {

/// Black but for what a test adds.
SkyShape night_shape(int edge) {
  return {.edge = edge, .zenith = {}, .horizon = {}, .ground = {}, .cloud = glm::vec3(1)};
}

/// The mean of red on the face above, and the share of its texels whose red exceeds a hundredth.
struct Above {
  double mean = 0, share = 0;
};
Above above(const SkyShape& shape) {
  const Sky sky = make_sky(shape);
  Above result;
  for (const Rgba& texel : sky.faces[2].pixels()) {
    result.mean += texel.r;
    result.share += texel.r > 0.01f;
  }
  const double count = double(shape.edge) * shape.edge;
  return {result.mean / count, result.share / count};
}

/// The texel in the middle of a face with an odd edge: in the direction of an axis.
Rgba axis_texel(const Sky& sky, std::size_t face) {
  const Image& image = sky.faces[face];
  return image.at(image.width() / 2, image.height() / 2);
}

}  // namespace

TEST_CASE("texels look where OpenGL's cube maps have them", "[sky]") {
  // Of 2 x 2 texels, the centre of column 1 in row 0: s = 1/2 and t = -1/2 by table 3.19 of the specification.
  const glm::dvec3 expected[] = {{1, 0.5, -0.5}, {-1, 0.5, 0.5}, {0.5, 1, -0.5},
                                 {0.5, -1, 0.5}, {0.5, 0.5, 1},  {-0.5, 0.5, -1}};
  for (int face = 0; face < 6; ++face) {
    INFO("face " << face);
    CHECK(glm::distance(texel_direction(face, 1, 0, 2), glm::normalize(expected[face])) < 1e-15);
  }
}

TEST_CASE("each texel has the colour of its direction", "[sky]") {
  const Sky sky = make_sky(3, [](const glm::dvec3& direction) { return direction; });
  for (int face = 0; face < 6; ++face)
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) {
        const glm::vec3 direction(texel_direction(face, column, row, 3));
        CHECK(sky.faces[std::size_t(face)].at(column, row) == Rgba{direction.x, direction.y, direction.z, 1});
      }
}

TEST_CASE("a gradient from the horizon to the zenith, and a plain ground", "[sky]") {
  const SkyShape shape{.edge = 65};
  const Sky sky = make_sky(shape);
  const auto is = [](const Rgba& texel, const glm::vec3& colour) {
    return texel == Rgba{colour.r, colour.g, colour.b, 1};
  };
  CHECK(is(axis_texel(sky, 2), shape.zenith));
  CHECK(is(axis_texel(sky, 3), shape.ground));
  for (const std::size_t side : {0, 1, 4, 5}) {
    CHECK(is(axis_texel(sky, side), shape.horizon));
    CHECK(is(sky.faces[side].at(32, 64), shape.ground));
    for (int row = 1; row <= 32; ++row) CHECK(sky.faces[side].at(32, row).r > sky.faces[side].at(32, row - 1).r);
  }
}

TEST_CASE("a disc has its colour, and its halo fades from its centre", "[sky]") {
  SkyShape shape = night_shape(65);
  shape.discs = {{.direction = {0, 5, 0}, .colour = {1, 2, 3}, .radius = 0.1f, .halo = {8, 0, 0}, .halo_width = 0.5f}};
  const Sky sky = make_sky(shape);
  CHECK(axis_texel(sky, 2) == Rgba{9, 2, 3, 1});
  // The horizon is sqrt(2) away, 2.83 widths: 8 / (1 + 8)^2 are left.
  CHECK(axis_texel(sky, 0).r == Approx(8.0 / 81));
  CHECK(axis_texel(sky, 0).g == 0);
  int covered = 0;
  for (const Rgba& texel : sky.faces[2].pixels()) covered += texel.g > 1;
  CHECK(covered == Approx(3.1416 * 0.1 * 0.1 / 4 * 65 * 65).margin(8));  // the face is 2 x 2; margin: its rim
  shape.discs[0].radius = 0;
  CHECK(axis_texel(make_sky(shape), 2) == Rgba{8, 0, 0, 1});
}

TEST_CASE("clouds cover about as much as they are asked to", "[sky]") {
  SkyShape shape = night_shape(48);
  CHECK(above(shape).share == 0);
  double before = 0;
  for (const float clouds : {0.25f, 0.5f, 0.75f, 1.0f}) {
    shape.clouds = clouds;
    const double mean = above(shape).mean;
    INFO(clouds << " asked for, " << mean << " covered");
    CHECK(mean > before);
    CHECK(std::abs(mean - double(clouds)) < 0.25);  // a few dozen lumps of noise are no even sample
    before = mean;
  }
  CHECK(before > 0.9);
  const Sky sky = make_sky(shape);
  CHECK(axis_texel(sky, 3).r == 0);  // none below the horizon
  shape.seed = 2;
  CHECK_FALSE(make_sky(shape).faces == sky.faces);
}

TEST_CASE("stars are small, and as many as they are asked to be", "[sky]") {
  SkyShape shape = night_shape(192);  // 4 x 4 texels in a place for a star
  CHECK(above(shape).share == 0);
  shape.stars = 1;
  const double all = above(shape).share;
  CHECK(all > 0.02);
  CHECK(all < 0.25);  // at most pi / 16 of a place is a star
  shape.stars = 0.25f;
  const double quarter = above(shape).share;
  CHECK(quarter > 0.15 * all);
  CHECK(quarter < 0.35 * all);
}
