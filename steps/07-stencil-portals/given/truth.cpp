#include "07-stencil-portals/given/truth.hpp"

#include "03-shadow-mapping/given/truth.hpp"
#include "05-normal-mapping/given/truth.hpp"
#include "07-stencil-portals/given/bodies_truth.hpp"
#include "07-stencil-portals/given/scenes.hpp"
#include "app/picture.hpp"
#include "oracle/portal.hpp"

namespace atelier {

namespace {

/// The camera at the end of a straight way, which portals bend: by the rules of visitor.hpp, but exactly, opening by
/// opening, instead of in steps.
Camera after_walk(Scene scene, Camera camera, const glm::dvec3& way) {
  std::erase_if(scene.portals, [](const Portal& portal) { return !portal.exit; });  // mirrors carry nobody
  const oracle::World world(scene);
  const oracle::Portals portals(scene);
  oracle::Segment segment{.ray = {.origin = camera.eye, .direction = way}};
  glm::dmat4 passed(1);
  while (const auto met = oracle::first_opening(world, portals, segment, 1)) {
    const oracle::Portals::Opening& opening = *portals.at(*met);
    passed = opening.through * passed;
    segment = oracle::beyond(opening, segment, met->t);
  }
  const auto carried = [&](const glm::dvec3& point) { return glm::dvec3(passed * glm::dvec4(point + way, 1)); };
  camera.eye = carried(camera.eye);
  camera.target = carried(camera.target);
  camera.up = glm::vec3(glm::dmat3(passed) * glm::dvec3(camera.up));
  return camera;
}

}  // namespace

SceneTruth portal_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model) {
  if (!model) {
    model = make_scene(whole_portal_scenes(), request.scene, settings);
    split_bodies_exactly(*model);
  }
  SceneTruth truth = normal_mapping_truth(request, settings, std::move(model));
  use_shadows(truth.shading, settings);
  truth.shading.portal_depth = settings.integer("portals.depth");
  truth.shading.portal_lights = settings.flag("portals.lights");
  const glm::dvec3 way = walk_of(truth.scene) * settings.real("visitor.way");
  if (way != glm::dvec3(0)) truth.camera = after_walk(truth.scene, apply(request.camera, truth.scene.camera), way);
  return truth;
}

}  // namespace atelier
