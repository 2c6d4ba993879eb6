#include "scene/builder.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace atelier {
namespace {

template <class Thing>
int append(std::vector<Thing>& things, Thing thing) {
  things.push_back(std::move(thing));
  return int(things.size()) - 1;
}

}  // namespace

int add_mesh(Scene& scene, Mesh mesh) {
  return append(scene.meshes, std::move(mesh));
}

int add_texture(Scene& scene, std::string name, Image pixels, Filter filter, Wrap wrap) {
  return append(scene.textures, Texture{std::move(name), std::move(pixels), wrap, filter});
}

int add_material(Scene& scene, Material material) {
  return append(scene.materials, std::move(material));
}

int add_relief(Scene& scene, Material material, Relief relief, bool coloured, Filter filter) {
  const std::string& name = material.name;
  if (coloured) material.diffuse_texture = add_texture(scene, name, std::move(relief.colour), filter);
  material.normal_texture = add_texture(scene, name + ": normals", std::move(relief.normal), filter);
  material.height_texture = add_texture(scene, name + ": heights", std::move(relief.height), filter);
  return add_material(scene, std::move(material));
}

int add_node(Scene& scene, Node node) {
  return append(scene.nodes, std::move(node));
}

int add_light(Scene& scene, Light light) {
  return append(scene.lights, std::move(light));
}

void set_background(Scene& scene, const glm::vec3& colour) {
  scene.background = colour;
  scene.sky.reset();
}

int add_object(Scene& scene, Mesh mesh, int material, Node node) {
  node.mesh = add_mesh(scene, std::move(mesh));
  node.material = material;
  return add_node(scene, std::move(node));
}

Node upright(Node node, double yaw) {
  // A quarter turn about x, then the yaw about y: the product of their quaternions as axis and angle.
  const double s = std::numbers::sqrt2 / 2, c = s;  // sine and cosine of half the quarter turn
  const double sy = std::sin(yaw / 2), cy = std::cos(yaw / 2);
  const glm::dvec3 axis(cy * s, sy * c, -sy * s);
  const double length = glm::length(axis);
  node.rotation_axis = glm::vec3(axis / length);
  node.rotation_angle = float(2 * std::atan2(length, cy * c));
  return node;
}

Material plastic(std::string name, const glm::vec3& colour, float exponent) {
  constexpr float gloss = 0.25f;
  return {.name = std::move(name), .diffuse = (1 - gloss) * colour, .specular = glm::vec3(gloss), .exponent = exponent};
}

Material metal(std::string name, const glm::vec3& reflectance, float exponent) {
  return {.name = std::move(name),
          .diffuse = 0.35f * reflectance * reflectance * reflectance,
          .specular = 0.65f * reflectance,
          .exponent = exponent};
}

}  // namespace atelier
