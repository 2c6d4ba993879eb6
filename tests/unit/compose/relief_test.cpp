// Normal maps and reliefs beside shadow maps.
#include "scene/relief.hpp"
#include "place.hpp"
#include "scene/builder.hpp"
#include "scene/shapes.hpp"

namespace {

using namespace atelier;
using namespace atelier::test;

/// A dimpled floor under a spot light and a point light, with a ball above it that casts shadows.
Scene dimpled_floor() {
  Scene scene;
  scene.ambient = glm::vec3(0);
  const Relief relief = make_dimples({.size = 64, .dimples = 4, .depth = 0.06f});
  Material clay{.diffuse = glm::vec3(0.6f), .specular = glm::vec3(0.2f)};
  clay.normal_texture = add_texture(scene, "normals", relief.normal, Filter::linear);
  clay.height_texture = add_texture(scene, "heights", relief.height, Filter::linear);
  add_object(scene, make_plane({.width = 4, .depth = 4}), add_material(scene, clay));
  const int plain = add_material(scene, {.diffuse = glm::vec3(0.5f)});
  add_object(scene, make_sphere({.radius = 0.5f}), plain, {.translation = {0, 1.2, 0}});
  add_light(scene, {.type = LightType::spot,
                    .position = {-2, 3, 0},
                    .direction = {0.6f, -1, 0},
                    .colour = glm::vec3(6),
                    .outer_angle = 0.9f});
  add_light(scene, {.position = {2, 3, 0.5}, .colour = glm::vec3(6)});
  scene.camera = {.eye = {0, 3.5, 3}, .target = {0, 0, 0}, .near = 0.5f, .far = 12};
  return scene;
}

int pixels_darker(const Image& a, const Image& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) count += a.pixels()[i].r < b.pixels()[i].r - 0.05f;
  return count;
}

}  // namespace

TEST_CASE("a relief keeps the shadows of other objects, and they keep it", "[compose]") {
  const Scene scene = dimpled_floor();
  Place place;
  place.open(features_of(4));
  const Image flat = place.draw(scene);
  place.open(with_reliefs(2));
  const Image unshadowed = place.draw(scene);
  place.open(with_reliefs(4));
  const Image both = place.draw(scene);
  CHECK(pixels_darker(both, unshadowed) > 200);  // the ball's shadows
  CHECK(largest_difference(both, flat) > 0.1);   // the relief
  // Where no shadow falls, shadow maps change nothing.
  int same = 0;
  for (std::size_t i = 0; i < both.pixels().size(); ++i) same += both.pixels()[i] == unshadowed.pixels()[i];
  CHECK(same > 96 * 96 / 3);
}

TEST_CASE("light in tangent space is that of world space, with shadows too", "[compose]") {
  const Scene scene = dimpled_floor();
  Place place;
  place.open(with_reliefs(4));
  const Image world = place.draw(scene);
  place.settings.set("normal.space", "tangent");
  place.open(with_reliefs(4));
  CHECK(largest_difference(place.draw(scene), world) < 1e-4);  // a rotation of vectors some metres long, in floats
}

TEST_CASE("visibilities multiply: shadows of the relief on itself beside those of shadow maps", "[compose]") {
  const Scene scene = dimpled_floor();
  Place place;
  place.settings.set("parallax.depth", "0.2");
  place.open(with_reliefs(4));
  const Image without = place.draw(scene);
  place.settings.set("parallax.shadow_samples", "32");
  place.open(with_reliefs(4));
  const Image with = place.draw(scene);
  CHECK(pixels_darker(with, without) > 10);
  CHECK(pixels_darker(without, with) == 0);
}

TEST_CASE("constants by varyings draw reliefs as uniforms do", "[compose]") {
  const Scene scene = dimpled_floor();
  Place place;
  for (const char* space : {"world", "tangent"}) {
    place.settings.set("normal.space", space);
    place.open(with_reliefs(4));
    const Image by_uniforms = place.draw(scene);
    place.open(with_reliefs(4), {.constants_as_varyings = true});
    CHECK(largest_difference(place.draw(scene), by_uniforms) == 0);
  }
}
