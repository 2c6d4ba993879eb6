#include "07-stencil-portals/given/truth.hpp"

#include "03-shadow-mapping/given/truth.hpp"
#include "05-normal-mapping/given/truth.hpp"
#include "07-stencil-portals/given/bodies_truth.hpp"
#include "07-stencil-portals/given/scenes.hpp"
#include "app/picture.hpp"
#include "oracle/portal.hpp"

namespace atelier {

namespace {

/// The camera at the end of a straight way, which portals bend: each is where a ray along the way meets it.
Camera after_walk(const Scene& scene, Camera camera, const glm::dvec3& way) {
  const oracle::World world(scene);
  const oracle::Portals portals(scene);
  oracle::Ray ray{.origin = camera.eye, .direction = way, .most = 1};
  glm::dmat4 passed(1);
  while (const auto met = world.seen(ray)) {
    const oracle::Portals::Opening* opening = portals.at(*met);
    if (!opening) break;  // a wall: the way of a scene leads through none before its end
    passed = opening->through * passed;
    ray = oracle::beyond(*opening, ray, met->t);
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
