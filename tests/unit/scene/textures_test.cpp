#include "scene/textures.hpp"
#include "scene/relief.hpp"

#include <bit>
#include <cmath>
#include <functional>

#include "catch.hpp"
#include "scene/noise.hpp"
#include "scene/sky.hpp"

using namespace atelier;
using atelier::test::error_of;

namespace {

/// FNV-1a over the bits of all pixels: one number that changes with any of them.
std::uint64_t fingerprint(const Image& image) {
  std::uint64_t h = 0xcbf29ce484222325u;
  for (const Rgba& p : image.pixels())
    for (const float c : {p.r, p.g, p.b, p.a}) h = (h ^ std::bit_cast<std::uint32_t>(c)) * 0x100000001b3u;
  return h;
}

/// Largest step of a channel between neighbours, across the seams and inside.
struct Steps {
  float inside = 0, across = 0;
};

Steps largest_steps(const Image& image) {
  const int n = image.width();
  const auto step = [&](int x, int y, int x2, int y2) {
    const Rgba &a = image.at(x, y), &b = image.at(x2, y2);
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
  };
  Steps steps;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j + 1 < n; ++j) steps.inside = std::max({steps.inside, step(j, i, j + 1, i), step(i, j, i, j + 1)});
    steps.across = std::max({steps.across, step(n - 1, i, 0, i), step(i, n - 1, i, 0)});
  }
  return steps;
}

/// A small sky with everything that a sky can have.
Sky dusky_sky() {
  SkyShape shape{.edge = 32,
                 .zenith = {0.05f, 0.05f, 0.15f},
                 .horizon = {0.3f, 0.15f, 0.15f},
                 .clouds = 0.5f,
                 .cloud = {0.2f, 0.15f, 0.15f},
                 .stars = 0.5f};
  shape.discs = {{.direction = {0.3f, 0.5f, -1},
                  .colour = glm::vec3(0.75f),
                  .radius = 0.1f,
                  .halo = glm::vec3(0.125f),
                  .halo_width = 0.25f}};
  return make_sky(shape);
}

struct MadeTexture {
  const char* name;
  std::function<Image()> make;
  std::uint64_t bits;
};

const std::vector<MadeTexture>& textures() {
  static const std::vector<MadeTexture> table = {
      {"checker", [] { return make_checker({.size = 64}); }, 0x1617b5b63f58a325},
      {"uv grid", [] { return make_uv_grid(64); }, 0x1ee489408595d95d},
      {"dots", [] { return make_dots({.size = 64}); }, 0x5273657880dbb4a5},
      {"wood", [] { return make_wood({.size = 64}); }, 0xfc1d247060538226},
      {"marble", [] { return make_marble({.size = 64}); }, 0xe906412b138ed518},
      {"brick colour", [] { return make_bricks({.size = 64}).colour; }, 0xd2b2a2d89d856ef0},
      {"brick height", [] { return make_bricks({.size = 64}).height; }, 0xae56c595302f832e},
      {"brick normal", [] { return make_bricks({.size = 64}).normal; }, 0x2df3e3745924a701},
      {"sky, above", [] { return dusky_sky().faces[2]; }, 0x37ae1afc970d4b6f},
      {"sky, towards the disc", [] { return dusky_sky().faces[5]; }, 0x77f85259fd434847},
  };
  return table;
}

}  // namespace

TEST_CASE("textures give the same bits everywhere, within 0..1", "[scene]") {
  for (const MadeTexture& row : textures()) {
    INFO(row.name);
    const Image image = row.make();
    for (const Rgba& p : image.pixels())
      if (!(p.r >= 0 && p.r <= 1 && p.g >= 0 && p.g <= 1 && p.b >= 0 && p.b <= 1 && p.a == 1)) FAIL("out of 0..1");
    CHECK(fingerprint(image) == row.bits);
    CHECK(fingerprint(row.make()) == row.bits);
  }
}

TEST_CASE("textures are seamless", "[scene]") {
  const auto closes = [](const Image& image) {
    const Steps steps = largest_steps(image);
    return steps.across <= steps.inside;
  };
  CHECK(closes(make_checker({.size = 128})));
  CHECK(closes(make_dots({.size = 128})));
  CHECK(closes(make_marble({.size = 256})));
  CHECK(closes(make_wood({.size = 256})));
  const Relief bricks = make_bricks({.size = 256});
  CHECK(closes(bricks.colour));
  CHECK(closes(bricks.height));
  CHECK(closes(bricks.normal));
  const Relief tiles = make_tiles({.size = 256});
  CHECK(closes(tiles.colour));
  CHECK(closes(tiles.height));
  CHECK(closes(make_inscription({.size = 256}).height));
}

TEST_CASE("seeds change the noise, and only the noise", "[scene]") {
  CHECK_FALSE(make_wood({.size = 32, .seed = 1}) == make_wood({.size = 32, .seed = 2}));
  CHECK_FALSE(make_marble({.size = 32, .seed = 1}) == make_marble({.size = 32, .seed = 2}));
  CHECK(make_marble({.size = 32, .seed = 5}) == make_marble({.size = 32, .seed = 5}));
}

TEST_CASE("the uv grid shows its orientation", "[scene]") {
  const Image grid = make_uv_grid(256);
  const auto same = [](const Rgba& a, const Rgba& b) { return a == b; };
  CHECK(same(grid.at(128, 0), {1, 1, 1, 1}));  // row 0 is the top, v near 1
  CHECK(same(grid.at(128, 255), {0, 0, 0, 1}));
  CHECK(grid.at(1, 100).b > 0.8f);  // cyan on the left
  CHECK(grid.at(1, 100).r == 0);
  CHECK(grid.at(254, 100).r > 0.8f);  // magenta on the right
  CHECK(grid.at(254, 100).g == 0);
  CHECK(grid.at(220, 128).r > grid.at(30, 128).r);          // red grows with u
  CHECK(grid.at(30, 30).g > grid.at(30, 220).g);            // green grows with v
  CHECK(same(grid.at(128, 256 - 180), {1, 1, 1, 1}));       // the arrow's head, above ...
  CHECK_FALSE(same(grid.at(128, 256 - 50), {1, 1, 1, 1}));  // ... and nothing below its shaft
}

TEST_CASE("the first square of a checker lies at the lower left", "[scene]") {
  const Image image = make_checker({.size = 8, .squares = 4, .first = {1, 0, 0}, .second = {0, 0, 1}});
  CHECK(image.at(0, 7) == Rgba{1, 0, 0});
  CHECK(image.at(2, 7) == Rgba{0, 0, 1});
  CHECK(image.at(0, 5) == Rgba{0, 0, 1});
}

TEST_CASE("brick normals are the slopes of the brick heights", "[scene]") {
  constexpr float depth = 0.05f;
  constexpr int n = 128;
  const Relief bricks = make_bricks({.size = n, .depth = depth});
  double low = 1, high = 0;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const Rgba& c = bricks.normal.at(x, y);
      const glm::dvec3 normal = glm::dvec3(c.r, c.g, c.b) * 2.0 - 1.0;
      if (std::abs(glm::length(normal) - 1) > 1e-6) FAIL("not unit length");  // three floats of 2^-24 each
      const auto h = [&](int i, int j) { return double(bricks.height.at((i + n) % n, (j + n) % n).r); };
      const double rises_right = h(x + 1, y) - h(x - 1, y), rises_up = h(x, y - 1) - h(x, y + 1);
      // Uphill to the right leans the normal to the left: -n.x / n.z is the slope.
      const double scale = depth * n / 2;
      if (std::abs(-normal.x / normal.z - scale * rises_right) > 1e-4 ||
          std::abs(-normal.y / normal.z - scale * rises_up) > 1e-4)  // a float's 6e-8 over the smallest n.z, 0.3
        FAIL("slope at " << x << ", " << y);
      low = std::min(low, h(x, y));
      high = std::max(high, h(x, y));
    }
  CHECK(low < 0.15);
  CHECK(high > 0.9);
}

TEST_CASE("dimples have the heights and slopes of their formula", "[scene]") {
  const DimpleShape shape{.size = 256, .dimples = 3, .depth = 0.05f};
  const Relief relief = make_dimples(shape);
  double most = 0;
  for (int y = 0; y < shape.size; ++y)
    for (int x = 0; x < shape.size; ++x) {
      const double u = (x + 0.5) / shape.size, v = 1 - (y + 0.5) / shape.size;
      const glm::dvec3 exact = dimples_at(shape, u, v);
      REQUIRE(relief.height.at(x, y).r == float(exact.x));
      const Rgba& c = relief.normal.at(x, y);
      const glm::dvec3 normal = glm::dvec3(c.r, c.g, c.b) * 2.0 - 1.0;
      const glm::dvec2 slope(-normal.x / normal.z, -normal.y / normal.z);
      most = std::max(most, glm::length(slope - double(shape.depth) * glm::dvec2(exact.y, exact.z)));
      // The formula's own slope, by small differences.
      const double step = 1e-6;
      const glm::dvec2 rise(dimples_at(shape, u + step, v).x - dimples_at(shape, u - step, v).x,
                            dimples_at(shape, u, v + step).x - dimples_at(shape, u, v - step).x);
      if (glm::length(rise / (2 * step) - glm::dvec2(exact.y, exact.z)) > 1e-3) FAIL("slope at " << u << ", " << v);
    }
  CHECK(most < 0.01);  // of central differences: a sixth of the third derivative times (1/256)^2
  CHECK(dimples_at(shape, 0.5, 0.5).x == 0);
  CHECK(dimples_at(shape, 0, 0).x == 1);
}

TEST_CASE("the inscription is carved, and is no mirror image of itself", "[scene]") {
  const Relief stone = make_inscription({.size = 256});
  int deep = 0, other = 0;
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) {
      const bool carved = stone.height.at(x, y).r < 0.3f;
      deep += carved;
      other += carved != (stone.height.at(255 - x, y).r < 0.3f);
    }
  CHECK(deep > 256 * 256 / 50);
  CHECK(deep < 256 * 256 / 10);
  CHECK(other > deep / 2);
}

TEST_CASE("noise repeats, stays within 0..1 and is even", "[scene]") {
  double sum = 0;
  for (int i = 0; i < 4096; ++i) {
    const glm::dvec2 p(i * 0.137, i * 0.071 - 100);
    const double value = value_noise(9, p, {8, 4});
    CHECK((value >= 0 && value <= 1));
    CHECK(value == Approx(value_noise(9, p + glm::dvec2(8, -4), {8, 4})).margin(1e-9));  // p loses bits when shifted
    sum += hash01(3, i, -i);
  }
  CHECK(sum / 4096 == Approx(0.5).margin(0.02));  // four standard errors of a mean of 4096 even numbers
}

TEST_CASE("textures refuse sizes out of range", "[scene]") {
  struct Bad {
    std::function<void()> make;
    const char* part;
  };
  const Bad table[] = {
      {[] { make_checker({.size = 0}); }, "checker: size 0 (allowed: 1..8192)"},
      {[] { make_checker({.size = 4, .squares = 5}); }, "squares 5 (allowed: 1..4)"},
      {[] { make_uv_grid(15); }, "uv grid: size 15"},
      {[] { make_dots({.dots = 3}); }, "even"},
      {[] { make_dots({.radius = 0.6f}); }, "radius 0.6"},
      {[] { make_dots({.radius = NAN}); }, "radius nan"},
      {[] { make_bricks({.rows = 7}); }, "rows 7 (allowed: even"},
      {[] { make_bricks({.columns = 0}); }, "columns 0"},
      {[] { make_bricks({.joint = 0.5f}); }, "joint 0.5"},
      {[] { make_bricks({.depth = -1}); }, "depth -1"},
      {[] { make_tiles({.tiles = 0}); }, "tiles: tiles 0"},
      {[] { make_dimples({.radius = 0.6f}); }, "dimples: radius 0.6"},
      {[] { make_dimples({.size = 0}); }, "size 0"},
      {[] { make_inscription({.stroke = 0.2f}); }, "inscription: stroke 0.2"},
      {[] { make_wood({.boards = 65}); }, "boards 65"},
      {[] { make_marble({.turbulence = 9}); }, "turbulence 9"},
      {[] { make_sky({.edge = 0}); }, "sky: edge 0 (allowed: 1..4096)"},
      {[] { make_sky({.edge = 4097}); }, "sky: edge 4097"},
      {[] { make_sky({.edge = 1, .clouds = NAN}); }, "sky: clouds nan"},
      {[] { make_sky({.edge = 1, .stars = -1}); }, "sky: stars -1"},
      {[] {
         make_sky({.edge = 1, .discs = {{.direction = {0, 0, 0}}}});
       },
       "direction 0"},
      {[] { make_sky({.edge = 1, .discs = {{.radius = 0.75f}}}); }, "radius of a disc 0.75 (allowed: 0..0.5)"},
      {[] { make_sky({.edge = 1, .discs = {{.halo_width = 0}}}); }, "halo_width of a disc 0"},
  };
  for (const Bad& bad : table) {
    INFO(bad.part);
    CHECK(error_of(bad.make).find(bad.part) != std::string::npos);
  }
}
