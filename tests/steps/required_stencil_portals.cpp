// Unused features cost nothing.
#include "catch.hpp"
#include "drawn.hpp"

using namespace atelier::test;

TEST_CASE("fog costs no pass and no memory, and nothing at density 0", "[required][07-stencil-portals]") {
  check_costs("07-stencil-portals", {
      {"fog", picture("posts"), {{"passes", 1}, {"texture_sources", 0}, {"target_bytes", picture_bytes}}},
      {"a picture of normals needs no fog", picture("posts", {}, "normal"), {{"passes", 1}, {"lights", 1}}},
  });
  const auto all = drawn("07-stencil-portals", {picture("posts", {{"stencil_portals.half_distance", 0.0}}),
                                 picture("posts", {{"stencil_portals.half_distance", 0.0}, {"stencil_portals.pieces", 4}}),
                                 picture("posts", {{"stencil_portals.pieces", 4}})});
  CHECK(pixels_apart(all[0].picture, all[1].picture) == 0);
  CHECK(pixels_apart(all[0].picture, all[2].picture) > 0);
}
