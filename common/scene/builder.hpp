// Helpers for building scenes in code: each adds one item and returns its index.
//
//   Scene scene{.name = "still life"};
//   const int wood = add_material(scene, {.diffuse_texture = add_texture(scene, "wood", make_wood())});
//   add_object(scene, make_torus(), wood, {.name = "ring", .translation = {0, 0.25, 0}});
#pragma once

#include <string>

#include "scene/relief.hpp"
#include "scene/scene.hpp"

namespace atelier {

int add_mesh(Scene& scene, Mesh mesh);
int add_texture(Scene& scene, std::string name, Image pixels, Filter filter = Filter::mipmap, Wrap wrap = Wrap::repeat);
int add_material(Scene& scene, Material material);
/// The material with the normals and heights of a relief, and with its colours if `coloured`.
int add_relief(Scene& scene, Material material, Relief relief, bool coloured, Filter filter = Filter::linear);
int add_node(Scene& scene, Node node);
int add_light(Scene& scene, Light light);

/// One linear colour behind everything: the background, without a sky.
void set_background(Scene& scene, const glm::vec3& colour);

/// Adds a mesh and a node that shows it; returns the node.
int add_object(Scene& scene, Mesh mesh, int material, Node node = {});

/// Rotates a node with a flat mesh like make_plane's (facing +y, texture's top towards -z) so that it faces +z with the
/// texture's top up, then by `yaw` radians around the y axis, counter-clockwise from above.
Node upright(Node node, double yaw);

/// Degrees to radians.
constexpr float degrees(double angle) {
  return float(angle * 3.14159265358979323846 / 180);
}

/// Plastic: coloured diffuse reflection under a colourless highlight. Darkens diffuse slightly so that diffuse +
/// specular <= 1.
Material plastic(std::string name, const glm::vec3& colour, float exponent = 64);

/// Metal: reflections are tinted by `reflectance`, the linear colour at normal incidence. There is no environment to
/// reflect, so one third goes to a diffuse part with the tint cubed: light scattered by a rough metal has been
/// reflected several times.
Material metal(std::string name, const glm::vec3& reflectance, float exponent = 64);

/// Linear reflectances of metals at normal incidence, from measured indices of refraction (Akenine-Moller et al.,
/// "Real-Time Rendering", 4th edition, table 9.2).
inline constexpr glm::vec3 copper_reflectance{0.955f, 0.638f, 0.538f};
inline constexpr glm::vec3 gold_reflectance{1.0f, 0.782f, 0.344f};
inline constexpr glm::vec3 silver_reflectance{0.972f, 0.960f, 0.915f};

}  // namespace atelier
