#include "05-normal-mapping/given/truth.hpp"

#include "02-blinn-phong/given/truth.hpp"
#include "05-normal-mapping/given/scenes.hpp"
#include "app/picture.hpp"
#include "oracle/frame.hpp"
#include "scene/builder.hpp"
#include "scene/relief.hpp"

namespace atelier {

namespace {

/// Gives every material with a height texture the normal map of its heights, and takes all others away.
void use_heights(Scene& scene, double depth) {
  for (Material& material : scene.materials) {
    material.normal_texture.reset();
    if (!material.height_texture || depth == 0) continue;
    Texture map = scene.textures[std::size_t(*material.height_texture)];
    map.pixels = normals_of_heights(map.pixels, depth, map.wrap);
    material.normal_texture = int(scene.textures.size());
    scene.textures.push_back(std::move(map));
  }
}

/// Normals as the camera sees them: along its right, its up, and towards it.
oracle::SurfaceColour in_view_of(const Camera& camera) {
  const oracle::ViewFrame frame = oracle::view_frame(camera.target - camera.eye, glm::dvec3(camera.up));
  return [frame](const oracle::World&, const oracle::SurfacePoint& point, const glm::dvec3&) {
    if (point.normal == glm::dvec3(0)) return glm::dvec3(0.5, 0.5, 1);
    return glm::dvec3(glm::dot(frame.right, point.normal), glm::dot(frame.up, point.normal),
                      -glm::dot(frame.ahead, point.normal)) *
               0.5 +
           0.5;
  };
}

}  // namespace

SceneTruth normal_mapping_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model) {
  if (!model) model = make_scene(normal_mapping_scenes(), request.scene, settings);
  SceneTruth truth = blinn_phong_truth(request, settings, std::move(model));
  truth.shading.normal_maps = settings.flag("normal.maps");
  if (settings.choice("normal.source") == "heights") use_heights(truth.scene, settings.real("normal.depth"));
  if (request.output == "recorded_normal") {
    truth.output = "colour";
    set_background(truth.scene, glm::vec3(0));
    truth.shading.surface = in_view_of(apply(request.camera, truth.scene.camera));
  }
  return truth;
}

}  // namespace atelier
