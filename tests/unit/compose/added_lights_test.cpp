// Lights that a feature adds equal the scene's own lights.
#include "catch.hpp"
#include "place.hpp"

namespace {

using namespace atelier;
using namespace atelier::test;

/// A lamp from the left, with shadows.
Light lamp() {
  return {.position = {-2, 3, 2}, .colour = {4, 3, 2}};
}

class Lamp : public Feature {
  void add_lights(const Scene&, std::vector<Light>& lights) const override { lights.push_back(lamp()); }
  Need need(const Scene&, const View&, const Node&) const override { return {}; }
};

}  // namespace

TEST_CASE("a light added by a feature equals a scene light, with its shadows", "[compose]") {
  Place place;
  Scene scene = make_scene(point_scenes(), "lantern", place.settings);
  FeatureList with_lamp = features_of(4);
  with_lamp.add<Lamp>();
  place.open(std::move(with_lamp));
  const Image added = place.draw(scene);
  place.open(features_of(4));
  const Image without = place.draw(scene);
  scene.lights.push_back(lamp());
  CHECK(added == place.draw(scene));
  CHECK_FALSE(added == without);
}
