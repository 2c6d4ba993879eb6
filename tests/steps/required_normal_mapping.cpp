// Unused features cost nothing.
#include "catch.hpp"
#include "drawn.hpp"

using namespace atelier;
using namespace atelier::test;

TEST_CASE("surfaces without a normal map have no tangents, no texture and no code for it",
          "[required][05-normal-mapping]") {
  check_costs(
      "05-normal-mapping",
      {
          {"a mapped wall: colours and normals",
           picture("wall"),
           {{"passes", 1}, {"attributes", 4}, {"texture_sources", 2}}},
          {"maps switched off", picture("wall", {{"normal.maps", false}}), {{"attributes", 3}, {"texture_sources", 1}}},
          {"tangents from derivatives are not stored",
           picture("wall", {{"normal.tangents", std::string("derivative")}}),
           {{"attributes", 3}, {"texture_sources", 2}}},
          {"a relief of depth 0",
           picture("wall", {{"normal.source", std::string("heights")}, {"normal.depth", 0.0}}),
           {{"attributes", 3}, {"texture_sources", 1}}},
          {"depth needs no normals", picture("wall", {}, "depth"), {{"attributes", 1}, {"texture_sources", 0}}},
          {"a scene without maps", picture("room"), {{"attributes", 3}}},
          {"normals without lights", picture("wall", {}, "normal"), {{"attributes", 4}, {"texture_sources", 1}}},
      });
}

TEST_CASE("maps of fewer bits need less memory", "[required][05-normal-mapping]") {
  const auto bytes = [](const char* format) {
    return drawn("05-normal-mapping", {picture("dimples", {{"normal.format", std::string(format)}})})[0].counts.at(
        "texture_bytes");
  };
  constexpr std::int64_t texels = 256 * 256;
  CHECK(bytes("32") == texels * 16);
  CHECK(bytes("16") == texels * 8);
  CHECK(bytes("8") == texels * 4);
}

TEST_CASE("what changes nothing changes no bit", "[required][05-normal-mapping]") {
  const auto all =
      drawn("05-normal-mapping", {picture("wall", {{"normal.maps", false}}),
                                  picture("wall", {{"normal.source", std::string("heights")}, {"normal.depth", 0.0}}),
                                  picture("wall"), picture("room"), picture("room", {{"normal.maps", false}})});
  CHECK(pixels_apart(all[0].picture, all[1].picture) == 0);
  CHECK(pixels_apart(all[0].picture, all[2].picture) > 1000);
  CHECK(pixels_apart(all[3].picture, all[4].picture) == 0);
}

TEST_CASE("corners without a frame are shaded as if unmapped", "[required][05-normal-mapping]") {
  const auto all = drawn("05-normal-mapping", {picture("degenerate"), picture("degenerate", {{"normal.maps", false}})});
  // The third and the fourth plate: the right half above the cone.
  for (int y = 0; y < 50; ++y)
    for (int x = 84; x < 160; ++x) REQUIRE(all[0].picture.at(x, y) == all[1].picture.at(x, y));
  CHECK(pixels_apart(all[0].picture, all[1].picture) > 300);
}
