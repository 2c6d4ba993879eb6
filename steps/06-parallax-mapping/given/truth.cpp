#include "06-parallax-mapping/given/truth.hpp"

#include <algorithm>
#include <memory>

#include "05-normal-mapping/given/truth.hpp"
#include "06-parallax-mapping/given/scenes.hpp"
#include "app/picture.hpp"
#include "oracle/frame.hpp"

namespace atelier {

namespace {

/// The height field of a node with a mesh of make_plane.
oracle::Shape height_field_of(const Scene& scene, const Node& node, const glm::dmat4& world, const Settings& settings) {
  const Mesh& mesh = scene.meshes[std::size_t(*node.mesh)];
  const Material& material = scene.materials[std::size_t(node.material)];
  glm::dvec3 half(0);
  glm::dvec2 repeat(0);
  for (const Vertex& vertex : mesh.vertices) {
    half = glm::max(half, glm::dvec3(glm::abs(vertex.position)));
    repeat = glm::max(repeat, glm::dvec2(vertex.texcoord));
  }
  oracle::HeightField field;
  field.flat = {.centre = glm::dvec3(0), .half_u = {half.x, 0, 0}, .half_v = {0, 0, -half.z}};
  field.heights = std::make_shared<const Texture>(scene.textures[std::size_t(*material.height_texture)]);
  field.depth = settings.real("parallax.depth") * 2 * half.x / repeat.x;
  field.repeat = repeat;
  field.window = true;  // the surface is a rectangle, and its pixels are all there is
  field.edges = settings.choice("parallax.edges") == "discard";
  return {.surface = field, .object_to_world = world, .material = node.material};
}

/// The height of what is seen: linear in the distance along the view direction.
oracle::SurfaceColour height_in_view(const Camera& camera, const Settings& settings) {
  const glm::dvec3 ahead = oracle::view_frame(camera.target - camera.eye, glm::dvec3(camera.up)).ahead;
  const double nearest = settings.real("recorded.nearest"), farthest = settings.real("recorded.farthest");
  return [=](const oracle::World&, const oracle::SurfacePoint& point, const glm::dvec3& eye) {
    const double distance = glm::dot(point.position - eye, ahead);
    return glm::dvec3(std::clamp((farthest - distance) / (farthest - nearest), 0.0, 1.0));
  };
}

}  // namespace

SceneTruth parallax_mapping_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model) {
  if (!model) model = make_scene(parallax_scenes(), request.scene, settings);
  SceneTruth truth = normal_mapping_truth(request, settings, std::move(model));
  if (request.output == "recorded_height") {
    truth.output = "colour";
    truth.scene.background = glm::vec3(0);
    truth.shading.surface = height_in_view(apply(request.camera, truth.scene.camera), settings);
  }
  if (settings.choice("parallax.method") == "none" || settings.real("parallax.depth") == 0) return truth;
  const std::vector<glm::dmat4> world = world_matrices_exact(truth.scene.nodes);
  const bool shadows = settings.integer("parallax.shadow_samples") > 0;
  if (shadows) truth.shading.shadows = oracle::Shadows::hard;
  for (std::size_t i = 0; i < truth.scene.nodes.size(); ++i) {
    Node& node = truth.scene.nodes[i];
    node.casts_shadow = node.receives_shadow = false;  // no shadow maps here
    if (node.name != relief_node || !node.mesh) continue;
    truth.shapes.push_back(height_field_of(truth.scene, node, world[i], settings));
    node.mesh.reset();
  }
  return truth;
}

}  // namespace atelier
