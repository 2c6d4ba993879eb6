// Texels: selection, filtering and wrapping.
#include "catch.hpp"
#include "pieces.hpp"

namespace atelier::test {
namespace {

/// Two rows of three texels: red tells the column, green the row from the bottom.
Texture numbered(Wrap wrap, Filter filter) {
  Texture texture{.name = "numbered", .pixels = Image(3, 2), .wrap = wrap, .filter = filter};
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x) texture.pixels.at(x, y) = {float(x), float(1 - y), 0, 1};
  return texture;
}

}  // namespace

TEST_CASE("the nearest texel, wrapped", "[texture]") {
  const struct {
    const char* name;
    Wrap wrap;
    glm::dvec2 at;
    double column, row;
  } rows[] = {
      {"lower left", Wrap::repeat, {0.01, 0.01}, 0, 0},
      {"upper right", Wrap::repeat, {0.99, 0.99}, 2, 1},
      {"right border repeats", Wrap::repeat, {1.0, 0.25}, 0, 0},
      {"left of it repeats", Wrap::repeat, {-0.01, 0.25}, 2, 0},
      {"far away repeats", Wrap::repeat, {1000.5, -999.75}, 1, 0},
      {"right border clamps", Wrap::clamp_to_edge, {1.5, 0.25}, 2, 0},
      {"below clamps", Wrap::clamp_to_edge, {0.5, -7}, 1, 0},
      {"just beyond is mirrored", Wrap::mirrored_repeat, {1.01, 0.25}, 2, 0},
      {"the second copy is mirrored", Wrap::mirrored_repeat, {1.99, 0.25}, 0, 0},
      {"the third is not", Wrap::mirrored_repeat, {2.01, 0.25}, 0, 0},
      {"to the left is mirrored", Wrap::mirrored_repeat, {-0.99, 1.25}, 2, 1},
      {"huge", Wrap::repeat, {1e30, 1e30}, 0, 0},
      {"huge, mirrored", Wrap::mirrored_repeat, {-1e30, 1e30}, 0, 0},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    const glm::dvec3 colour = oracle::texel_colour(numbered(row.wrap, Filter::nearest), row.at);
    if (std::abs(row.at.x) > 1e15) {
      CHECK((colour.r >= 0 && colour.r <= 2));  // no digit is left to say which
      continue;
    }
    CHECK(colour.r == row.column);
    CHECK(colour.g == row.row);
  }
}

TEST_CASE("four texels, mixed", "[texture]") {
  for (const Filter filter : {Filter::linear, Filter::mipmap}) {
    const Texture repeat = numbered(Wrap::repeat, filter), clamp = numbered(Wrap::clamp_to_edge, filter);
    CHECK(glm::length(oracle::texel_colour(repeat, {0.5, 0.75}) - glm::dvec3(1, 1, 0)) < 1e-15);         // a centre
    CHECK(glm::length(oracle::texel_colour(repeat, {1 / 3.0, 0.5}) - glm::dvec3(0.5, 0.5, 0)) < 1e-15);  // a corner
    CHECK(oracle::texel_colour(repeat, {0, 0.25}).r == Approx(1));  // between the last column and the first
    CHECK(oracle::texel_colour(clamp, {0, 0.25}).r == 0);
    CHECK(oracle::texel_colour(clamp, {1, 1}).r == 2);
  }
}

}  // namespace atelier::test
