#include "06-parallax-mapping/given/truth.hpp"

#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <memory>

#include "05-normal-mapping/given/truth.hpp"
#include "06-parallax-mapping/given/relief_surface.hpp"
#include "06-parallax-mapping/given/scenes.hpp"
#include "app/picture.hpp"
#include "oracle/frame.hpp"
#include "oracle/texture.hpp"
#include "scene/builder.hpp"
#include "scene/shape_detail.hpp"

namespace atelier {

namespace {

/// The mesh of make_cylinder_wall with its relief: a grid of two squares of texels each, moved inwards. The normals
/// stay those of the cylinder, to which the normal map belongs.
Mesh round_relief_of(const Mesh& wall, const Texture& heights, double depth) {
  double radius = 0, top = 0;
  glm::dvec2 repeat(0);
  for (const Vertex& vertex : wall.vertices) {
    radius = std::max(radius, std::abs(double(vertex.position.x)));
    top = std::max(top, double(vertex.position.y));
    repeat = glm::max(repeat, glm::dvec2(vertex.texcoord));
  }
  const double deepest = depth * 2 * glm::pi<double>() * radius / repeat.x;
  const int columns = int(repeat.x * heights.pixels.width() / 2), rows = int(repeat.y * heights.pixels.height() / 2);
  Mesh mesh{.name = "relief"};
  shape_detail::add_grid(mesh, columns, rows, [&](int column, int row) {
    const glm::dvec2 turn = shape_detail::circle_point(column, columns);
    const glm::dvec3 outwards(turn.x, 0, -turn.y);
    const glm::dvec2 share(double(column) / columns, double(row) / rows), texcoord = share * repeat;
    const double inwards = deepest * (1 - oracle::texel_colour(heights, texcoord).r);
    const glm::dvec3 position = (radius - inwards) * outwards + glm::dvec3(0, share.y * top, 0);
    return Vertex{glm::vec3(position), glm::vec3(outwards), glm::vec2(texcoord)};
  });
  return mesh;
}

}  // namespace

oracle::Shape relief_shape(const Scene& scene, const Node& node, const glm::dmat4& world, const Settings& settings) {
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

oracle::SurfaceColour height_in_view(const Camera& camera, const glm::dvec2& range) {
  const glm::dvec3 ahead = oracle::view_frame(camera.target - camera.eye, glm::dvec3(camera.up)).ahead;
  return [=](const oracle::World&, const oracle::SurfacePoint& point, const glm::dvec3& eye) {
    const double distance = glm::dot(point.position - eye, ahead);
    return glm::dvec3(std::clamp((range.y - distance) / (range.y - range.x), 0.0, 1.0));
  };
}

SceneTruth parallax_mapping_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model) {
  const glm::dvec2 range = recorded_range(settings);
  if (!model) model = make_scene(parallax_scenes(), request.scene, settings);
  SceneTruth truth = normal_mapping_truth(request, settings, std::move(model));
  if (request.output == "recorded_height") {
    truth.output = "colour";
    set_background(truth.scene, glm::vec3(0));
    truth.shading.surface = height_in_view(apply(request.camera, truth.scene.camera), range);
  }
  if (settings.choice("parallax.method") == "none" || settings.real("parallax.depth") == 0) return truth;
  const std::vector<glm::dmat4> world = world_matrices_exact(truth.scene.nodes);
  const bool shadows = settings.integer("parallax.shadow_samples") > 0;
  if (shadows) truth.shading.shadows = oracle::Shadows::hard;
  for (std::size_t i = 0; i < truth.scene.nodes.size(); ++i) {
    Node& node = truth.scene.nodes[i];
    node.casts_shadow = node.receives_shadow = false;  // no shadow maps here
    if (node.mesh && node.name == round_relief_node) {
      const Material& material = truth.scene.materials[std::size_t(node.material)];
      const Texture& heights = truth.scene.textures[std::size_t(*material.height_texture)];
      node.mesh = add_mesh(truth.scene, round_relief_of(truth.scene.meshes[std::size_t(*node.mesh)], heights,
                                                        settings.real("parallax.depth")));
    }
    if (node.name != relief_node || !node.mesh) continue;
    truth.shapes.push_back(relief_shape(truth.scene, node, world[i], settings));
    node.mesh.reset();
  }
  return truth;
}

}  // namespace atelier
