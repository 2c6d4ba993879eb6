// The blind of step 02 with vertex lighting. For lighting per pixel, truth.cpp compares the references with the truth.
#include "catch.hpp"
#include "drawn.hpp"

using namespace atelier;
using namespace atelier::test;

TEST_CASE("a blind darkens vertices as it does pixels", "[blind][02-blinn-phong]") {
  const auto plate = [](const char* shading, bool blind) {
    return picture("plate", {{"shading", std::string(shading)}, {"light.blind", blind}, {"plate.cells", 512}});
  };
  const auto all = drawn("02-blinn-phong", {plate("vertex", true), plate("pixel", true), plate("pixel", false)});
  // Corners are h = 8 mm apart, and an edge's ramp is a = 8 cm wide on the plate: linear interpolation errs by h^2/8 of
  // the second derivative, 3/a^2: 0.4 % of the light, less than one code of any colour.
  CHECK(codes_apart(all[0].picture, all[1].picture) < 1);
  CHECK(codes_apart(all[1].picture, all[2].picture) > 20);
}
