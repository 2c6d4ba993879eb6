// Unused features cost nothing.
#include "catch.hpp"
#include "drawn.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

constexpr const char* parallax_step = "06-parallax-mapping";

}  // namespace

TEST_CASE("surfaces without a relief have no height map, no tangents and no march", "[required][06-parallax-mapping]") {
  check_costs(
      parallax_step,
      {
          {"bricks: colours, normals and heights", picture("bricks"), {{"texture_sources", 3}, {"lookups", 35}}},
          {"no method",
           picture("bricks", {{"parallax.method", text("none")}}),
           {{"texture_sources", 2}, {"lookups", 0}}},
          {"no depth, and so a flat normal map",
           picture("bricks", {{"parallax.depth", 0.0}}),
           {{"texture_sources", 1}, {"lookups", 0}}},
          {"one lookup", picture("bricks", {{"parallax.method", text("offset")}}), {{"lookups", 1}}},
          {"bisections only in relief mapping", picture("bricks", {{"parallax.bisections", 16}}), {{"lookups", 35}}},
          {"a sample for each light and step", picture("bricks", {{"parallax.shadow_samples", 10}}), {{"lookups", 45}}},
          {"over a curved surface the secant is in the march",
           picture("bricks", {{"parallax.silhouette", true}}),
           {{"lookups", 33}}},
          {"a scene without reliefs", picture("room"), {{"attributes", 3}, {"lookups", 0}}},
          {"without normal maps the relief has its own tangents",
           picture("bricks", {{"normal.maps", false}}),
           {{"attributes", 4}, {"texture_sources", 2}}},
      });
}

TEST_CASE("a relief of depth 0 is step 05 to the last bit", "[required][06-parallax-mapping]") {
  const auto all =
      drawn(parallax_step, {picture("bricks", {{"parallax.depth", 0.0}}),
                            picture("bricks", {{"parallax.depth", 0.0}, {"parallax.method", text("none")}}),
                            picture("bricks"), picture("bricks", {{"parallax.method", text("none")}})});
  CHECK(pixels_apart(all[0].picture, all[1].picture) == 0);
  CHECK(pixels_apart(all[2].picture, all[3].picture) > 1000);
}

TEST_CASE("on a flat surface the curvature changes nothing", "[required][06-parallax-mapping]") {
  const auto all = drawn(parallax_step, {picture("bricks"), picture("bricks", {{"parallax.silhouette", true}})});
  CHECK(pixels_apart(all[0].picture, all[1].picture) <= 10);  // rounding decides on a step at a brick's edge
}

TEST_CASE("loops are bounded whatever the view", "[required][06-parallax-mapping]") {
  // Along the surface, and from below it: nothing is seen, and nothing hangs.
  Case flat = picture("bricks", {{"parallax.layers", 256}, {"parallax.shadow_samples", 256}});
  flat.camera.eye = {2, 1e-4, 2};
  const auto all = drawn(parallax_step, {flat});
  for (const Rgba& p : all[0].picture.pixels())
    REQUIRE((std::isfinite(p.r) && std::isfinite(p.g) && std::isfinite(p.b)));
}
