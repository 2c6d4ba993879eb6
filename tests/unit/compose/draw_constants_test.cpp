// Draw constants reach the fragment stage as uniforms or as varyings: the pictures of steps 02 to 04 are the same to
// the last bit.
#include "place.hpp"

namespace {

using namespace atelier;
using namespace atelier::test;

using Values = std::map<std::string, std::string>;

void check_both_ways(Place& place, int step, const Scene& scene, const char* output = "colour") {
  place.open(features_of(step));
  const Image by_uniforms = place.draw(scene, output);
  place.open(features_of(step), {.constants_as_varyings = true});
  CHECK(place.draw(scene, output) == by_uniforms);
}

/// More point lights than any driver has varyings for, each of another colour.
Scene crowded(const Place& place) {
  Scene scene = make_scene(point_scenes(), "lantern", place.settings);
  for (int i = 0; i < 60; ++i)
    scene.lights.push_back({.position = {0.2 * i - 6, 3 + 0.01 * i, 2},
                            .colour = {0.1f + 0.01f * float(i), 0.4f, 0.7f - 0.01f * float(i)},
                            .casts_shadow = false});
  return scene;
}

}  // namespace

TEST_CASE("constants by varyings draw every scene as uniforms do, to the last bit", "[compose]") {
  const struct {
    int step;
    const SceneTable& scenes;
    std::vector<const char*> outputs;
  } steps[] = {{2, blinn_phong_scenes(), {"colour", "specular"}},
               {3, shadow_scenes(), {"colour", "shadow_factor"}},
               {4, point_scenes(), {"colour", "shadow_factor"}}};
  Place place;
  for (const auto& row : steps)
    for (const NamedScene& named : row.scenes)
      for (const char* output : row.outputs) {
        INFO("step 0" << row.step << ", scene " << named.name << ", " << output);
        check_both_ways(place, row.step, make_scene(row.scenes, named.name, place.settings), output);
      }
}

TEST_CASE("constants by varyings draw every variant of the shaders as uniforms do", "[compose]") {
  const struct {
    const char* name;
    int step;
    const char* scene;
    Values settings;
  } rows[] = {
      {"a table of powers", 2, "teapot", {{"specular.power", "table"}, {"specular.normalisation", "exact"}}},
      {"a stable power", 2, "teapot", {{"specular.power", "stable"}}},
      {"decoded after filtering", 2, "tiles", {{"texture.decode", "after"}}},
      {"a wide filter", 3, "table", {{"shadow.pcf", "3"}, {"shadow.bias", "slope"}, {"shadow.filter", "bilinear"}}},
      {"half-shadows", 3, "three-spots", {{"shadow.soft", "pcss"}, {"light.width", "0.2"}, {"shadow.bias", "plane"}}},
      {"random samples", 3, "table", {{"shadow.soft", "pcss"}, {"shadow.pattern", "random"}, {"light.width", "0.1"}}},
      {"cubes alone", 4, "lantern", {{"cube.instead", "never"}, {"shadow.pcf", "2"}}},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    Place place;
    for (const auto& [name, value] : row.settings) place.settings.set(name, value);
    const SceneTable scenes = row.step == 2 ? blinn_phong_scenes() : row.step == 3 ? shadow_scenes() : point_scenes();
    check_both_ways(place, row.step, make_scene(scenes, row.scene, place.settings));
  }
}

TEST_CASE("lights that do not fit into varyings stay uniforms", "[compose]") {
  Place place;
  place.settings.set("light.cull", "false");
  const Scene scene = crowded(place);
  check_both_ways(place, 4, scene);
  place.open(features_of(4), {.constants_as_varyings = true});
  const Image all = place.draw(scene);
  place.settings.set("light.count", "1");
  place.open(features_of(4), {.constants_as_varyings = true});
  CHECK_FALSE(place.draw(scene) == all);
}
