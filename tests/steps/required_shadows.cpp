// Only required shadows: no map, no pass and no shader code without visible shadows.
#include "catch.hpp"
#include "drawn.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

constexpr const char* shadows_step = "03-shadow-mapping";
constexpr std::int64_t map_bytes = 256 * 256 * 4;  ///< the same of a map

/// With maps of 256 x 256 texels.
Case shadowed(const std::string& scene, std::map<std::string, SettingValue> settings = {},
              const std::string& output = "colour") {
  settings["shadow.resolution"] = 256;
  return picture(scene, std::move(settings), output);
}

}  // namespace

TEST_CASE("unused shadows cost nothing", "[required][03-shadow-mapping]") {
  const std::vector<Priced> rows = {
      {"a lamp and what casts: one map, one pass into it, one texture looked up",
       shadowed("table"),
       {{"passes", 2}, {"texture_sources", 1}, {"target_bytes", picture_bytes + map_bytes}, {"lookups", 1}}},
      {"no lamp: no map, no pass, no code, no normal",
       shadowed("table", {{"light.count", 0}}),
       {{"passes", 1}, {"texture_sources", 0}, {"target_bytes", picture_bytes}, {"attributes", 1}}},
      {"three lamps: a map and a pass each, in one texture",
       shadowed("three-spots"),
       {{"passes", 4}, {"target_bytes", picture_bytes + 3 * map_bytes}, {"lookups", 3}}},
      {"3 x 3 comparisons of four texels",
       shadowed("table", {{"shadow.pcf", 3}, {"shadow.filter", std::string("bilinear")}}),
       {{"lookups", 36}}},
      {"sixteen samples, for blockers and again",
       shadowed("table", {{"shadow.soft", std::string("pcss")}, {"light.width", 0.5}}),
       {{"lookups", 32}}},
      {"the first of them alone",
       shadowed("three-spots", {{"light.count", 1}}),
       {{"passes", 2}, {"target_bytes", picture_bytes + map_bytes}}},
      {"two lamps, and one that shines at the sky, where nothing casts: two maps",
       shadowed("edges"),
       {{"lights", 3}, {"passes", 3}, {"target_bytes", picture_bytes + 2 * map_bytes}}},
      {"a picture of normals: no map",
       shadowed("table", {}, "normal"),
       {{"passes", 1}, {"texture_sources", 0}, {"target_bytes", picture_bytes}, {"lookups", 0}}},
      {"16 bits of depth are half as many bytes",
       shadowed("table", {{"shadow.format", std::string("16")}}),
       {{"target_bytes", picture_bytes + map_bytes / 2}}},
  };
  check_costs(shadows_step, rows);
}

TEST_CASE("surfaces that receive no shadow have no code for it", "[required][03-shadow-mapping]") {
  // Beside the variants that the materials themselves make: one for the box that receives nothing, one for the maps.
  const auto all =
      drawn(shadows_step, {shadowed("edges", {{"light.cull", false}}), shadowed("edges", {{"light.count", 0}})});
  CHECK(all[0].counts.at("variants") == all[1].counts.at("variants") + 2);
}

TEST_CASE("only casters in a light's view are drawn into its map", "[required][03-shadow-mapping]") {
  // From far down the colonnade, where most of it is behind the eye.
  Case scene = shadowed("colonnade"), visible = shadowed("colonnade", {{"shadow.fit", std::string("visible")}});
  for (Case* one : {&scene, &visible}) {
    one->camera.eye = glm::dvec3(0.3, 1.7, -14);
    one->camera.target = glm::dvec3(0, 1.5, -20);
  }
  const auto all = drawn(shadows_step, {shadowed("table", {{"light.count", 0}}), shadowed("table"), scene, visible});
  const auto draws = [&](std::size_t i) { return all[i].counts.at("draws"); };
  CHECK(draws(1) - draws(0) == 6);  // top, four legs and ball; the floor casts no shadow
  CHECK(draws(3) < draws(2) - 20);  // what throws its shadow out of sight
  CHECK(draws(3) > 0);
}

TEST_CASE("shadow maps of static scenes are drawn once", "[required][03-shadow-mapping]") {
  for (const char* scene : {"table", "three-spots", "edges", "colonnade"}) {
    INFO(scene);
    const auto first = drawn(shadows_step, {shadowed(scene)})[0].counts;
    const auto later = counts_at_rest(shadows_step, shadowed(scene));
    CHECK(first.at("passes") > 1);
    CHECK(later.at("passes") == 1);
    CHECK(later.at("draws") < first.at("draws"));
    CHECK(later.at("allocated_bytes") == 0);
    const auto always = counts_at_rest(shadows_step, shadowed(scene, {{"shadow.update", std::string("always")}}));
    CHECK(always.at("passes") == first.at("passes"));
    CHECK(always.at("draws") == first.at("draws"));
  }
}

TEST_CASE("a map that is drawn in every frame has all texels that the picture samples",
          "[required][03-shadow-mapping]") {
  std::vector<Case> pictures;
  const auto both = [&](Case one, int resolution = 64) {
    one.settings["shadow.resolution"] = resolution;  // coarse, so that a texel that is missing is many pixels
    pictures.push_back(one);
    one.settings["light.turn"] = 180.0;  // what is not drawn in the next picture shows this one's shadows
    pictures.push_back(one);
    one.settings.erase("light.turn");
    one.settings["shadow.update"] = std::string("always");
    pictures.push_back(one);
  };
  for (const char* scene : {"table", "three-spots", "grazing", "cubes", "edges"}) {
    both(shadowed(scene));
    both(shadowed(scene, {{"shadow.filter", std::string("bilinear")}}), 16);
    both(shadowed(scene, {{"shadow.bias_size", 12.0}}), 16);
    both(shadowed(scene, {{"shadow.pcf", 15}}));
    both(shadowed(scene, {{"shadow.pcf", 3}, {"shadow.filter", std::string("bilinear")}, {"shadow.bias_size", 12.0}}));
    both(shadowed(scene, {{"shadow.bias", std::string("plane")}}));
    both(shadowed(scene, {{"shadow.soft", std::string("pcss")}, {"light.width", 0.5}}));
    both(shadowed(scene, {{"shadow.fit", std::string("fixed")}, {"shadow.reach", 8.0}}));
  }
  Case inside = shadowed("colonnade");  // most of it behind the eye
  inside.camera.eye = glm::dvec3(0.3, 1.7, -14);
  inside.camera.target = glm::dvec3(0, 1.5, -20);
  both(inside);
  const auto all = drawn(shadows_step, pictures);
  for (std::size_t i = 0; i < all.size(); i += 3) {
    INFO(pictures[i].scene << ", no. " << i / 3);
    CHECK(pixels_apart(all[i].picture, all[i + 2].picture) == 0);
  }
}

TEST_CASE("penumbras of a directional light do not depend on the fit of its map", "[required][03-shadow-mapping]") {
  // The columns begin long before the middle of the box that only casters and what is seen of receivers share.
  const std::map<std::string, SettingValue> soft{{"shadow.soft", std::string("pcss")}, {"light.width", 0.05}};
  std::map<std::string, SettingValue> visible = soft;
  visible["shadow.fit"] = std::string("visible");
  const auto all = drawn(shadows_step,
                         {shadowed("colonnade", soft, "shadow_factor"), shadowed("colonnade", visible, "shadow_factor"),
                          shadowed("colonnade", {}, "shadow_factor")});
  const auto dark = [](const Image& factor) {
    return std::ranges::count_if(factor.pixels(), [](const Rgba& p) { return p.r < 0.5f; });
  };
  // Coarse texels and fine ones, wide half-shadows and hard edges: none takes or adds a fifth of the shadows.
  for (const Drawn& one : all) CHECK(std::abs(double(dark(one.picture)) / double(dark(all[2].picture)) - 1) < 0.2);
}

TEST_CASE("a directional light needs no perspective", "[required][03-shadow-mapping]") {
  // Its box begins at the plane 0, which step 01's perspective refuses: a picture at all is the proof.
  const auto all = drawn(shadows_step, {shadowed("colonnade"), shadowed("grazing")});
  for (const Drawn& one : all) CHECK(one.counts.at("passes") == 2);
}

TEST_CASE("shadows do not depend on the size of the scene", "[required][03-shadow-mapping]") {
  std::vector<Case> pictures;
  for (const double scale : {1.0, 1e-3, 1e5})
    for (const char* bias : {"constant", "slope", "normal", "plane"})
      pictures.push_back(
          shadowed("table", {{"scene.scale", scale}, {"shadow.bias", std::string(bias)}}, "shadow_factor"));
  const auto all = drawn(shadows_step, pictures);
  for (std::size_t i = 4; i < all.size(); ++i) {
    INFO("picture " << i);
    // Roundings move the edges of shadows across the middles of a few of the 19200 pixels.
    CHECK(pixels_apart(all[i].picture, all[i % 4].picture) <= 20);
  }
}

TEST_CASE("a map of one texel, and light at 89.9 degrees, give fractions of light", "[required][03-shadow-mapping]") {
  std::vector<Case> pictures;
  for (const char* bias : {"none", "constant", "slope", "normal", "plane", "front-faces"})
    for (const char* soft : {"pcf", "pcss"}) {
      Case one = shadowed(
          "table", {{"shadow.bias", std::string(bias)}, {"shadow.soft", std::string(soft)}, {"light.width", 0.5}},
          "shadow_factor");
      one.settings["shadow.resolution"] = 1;
      pictures.push_back(one);
      pictures.push_back(shadowed(
          "grazing", {{"shadow.bias", std::string(bias)}, {"shadow.soft", std::string(soft)}, {"grazing.angle", 89.9}},
          "shadow_factor"));
    }
  for (const Drawn& one : drawn(shadows_step, pictures)) {
    int strange = 0;
    for (const Rgba& p : one.picture.pixels()) strange += !(p.r >= 0 && p.r <= 1);
    CHECK(strange == 0);
  }
}
