// Passes that change nothing do not run, and what a look does not need is not made.
#include "catch.hpp"
#include "drawn.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

constexpr const char* post_step = "08-post-processing";

Case lanterns(std::map<std::string, SettingValue> settings = {}) {
  return picture("lanterns", std::move(settings));
}

}  // namespace

TEST_CASE("a pass that is not needed costs nothing", "[required][08-post-processing]") {
  check_costs(post_step,
              {
                  {"no pass: the scene alone", lanterns(), {{"passes", 1}, {"target_bytes", picture_bytes}}},
                  {"whole turns of hue", lanterns({{"colour.hue", 1.0}}), {{"passes", 1}}},
                  {"one pass", lanterns({{"tone.exposure", 1.0}}), {{"passes", 2}}},
                  {"two passes", lanterns({{"tone.exposure", 1.0}, {"colour.saturation", 0.5}}), {{"passes", 3}}},
                  {"two passes in one",
                   lanterns({{"tone.exposure", 1.0}, {"colour.saturation", 0.5}, {"chain.fused", true}}),
                   {{"passes", 2}}},
                  {"bloom is four passes", lanterns({{"bloom.strength", 1.0}}), {{"passes", 5}}},
                  {"no bloom for normals", picture("lanterns", {{"bloom.strength", 1.0}}, "normal"), {{"passes", 1}}},
              });
}

TEST_CASE("fused passes show the same as separate ones", "[required][08-post-processing]") {
  std::map<std::string, SettingValue> look = {
      {"tone.curve", std::string("filmic")}, {"tone.exposure", 1.0},  {"colour.hue", 0.1},
      {"table.look", std::string("warm")},   {"overlay.amount", 0.5}, {"bloom.strength", 0.5}};
  const Case separate = lanterns(look);
  look["chain.fused"] = true;
  const auto both = drawn(post_step, {separate, lanterns(look)});
  float most = 0;
  for (std::size_t i = 0; i < both[0].picture.pixels().size(); ++i) {
    const Rgba &a = both[0].picture.pixels()[i], &b = both[1].picture.pixels()[i];
    most = std::max({most, std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
  }
  CHECK(most < 1e-5f);
}
