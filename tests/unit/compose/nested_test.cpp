// A view inside a view has the same shadows as alone: shadow maps are drawn for each view.
#include <glm/gtc/matrix_transform.hpp>

#include "catch.hpp"
#include "nesting.hpp"
#include "place.hpp"
#include "scene/builder.hpp"
#include "scene/shapes.hpp"

namespace {

using namespace atelier;
using namespace atelier::test;

/// A window that shows the scene from where the eye is: as if it were not there.
struct ClearWindow : Feature {
  bool needs_stencil(const Scene&) const override { return true; }
  Need need(const Scene&, const View&, const Node&) const override { return {}; }
  bool hides(const Scene&, const View&, const Node& node) const override { return node.name == "window"; }
  void draw_inside(Gl&, const Scene& scene, const Viewpoint& around, const Target& target,
                   ScenePainter& painter) override {
    if (around.view.parent) return;
    View inside = around.view;
    inside.world_to_view = around.world_to_view;
    for (int i = 0; i < int(painter.items().size()); ++i)
      if (scene.nodes[std::size_t(painter.items()[std::size_t(i)].node)].name == "window") {
        ++views;
        painter.draw_view_inside(inside, around, target, i, nesting());
      }
  }
  int views = 0;
};

/// The scene with a window half a metre before the eye that covers the middle of the picture.
Scene with_window(Scene scene) {
  const glm::dvec3 ahead = glm::normalize(scene.camera.target - scene.camera.eye);
  Mesh square = make_plane({.width = 0.15f, .depth = 0.15f});
  const int mesh = add_mesh(scene, std::move(square));
  Node node{.name = "window", .mesh = mesh, .casts_shadow = false, .receives_shadow = false};
  const glm::mat4 turned = glm::inverse(glm::lookAt(glm::vec3(0), glm::vec3(ahead), scene.camera.up)) *
                           glm::rotate(glm::mat4(1), glm::radians(90.0f), glm::vec3(1, 0, 0));
  node.matrix = glm::translate(glm::mat4(1), glm::vec3(scene.camera.eye + 0.5 * ahead)) * turned;
  scene.nodes.push_back(node);
  return scene;
}

}  // namespace

TEST_CASE("a portal to the view behind it changes nothing, for every shadow-map update mode", "[compose]") {
  for (const char* update : {"when-moved", "always"})
    for (const int step : {3, 4}) {
      INFO("step 0" << step << ", shadow.update " << update);
      Place place;
      place.settings.set("shadow.update", update);
      Scene scene = step == 3 ? make_scene(shadow_scenes(), "teapot", place.settings)
                              : make_scene(point_scenes(), "lantern", place.settings);
      scene.camera.near = 0.25f;
      place.open(features_of(step));
      const Image plain = place.draw(scene);
      FeatureList features = features_of(step);
      const auto& seen = features.add<ClearWindow>();
      place.open(std::move(features));
      // The eye of a given matrix is taken from its inverse, whose last bits differ: highlights follow by some 4e-6.
      CHECK(largest_difference(place.draw(with_window(scene)), plain) < 2e-5);
      CHECK(seen.views == 1);
    }
}
