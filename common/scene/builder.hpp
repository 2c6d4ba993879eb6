// Small words for writing scenes by hand: each adds one thing and returns its index.
//
//   Scene scene{.name = "still life"};
//   const int wood = add_material(scene, {.diffuse_texture = add_texture(scene, "wood", make_wood())});
//   add_object(scene, make_torus(), wood, {.name = "ring", .translation = {0, 0.25, 0}});
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace atelier {

int add_mesh(Scene& scene, Mesh mesh);
int add_texture(Scene& scene, std::string name, Image pixels, Filter filter = Filter::mipmap, Wrap wrap = Wrap::repeat);
int add_material(Scene& scene, Material material);
int add_node(Scene& scene, Node node);
int add_light(Scene& scene, Light light);

/// A mesh and a node that shows it, in one go; returns the node.
int add_object(Scene& scene, Mesh mesh, int material, Node node = {});

/// Turns a node whose mesh lies flat as make_plane does (facing +y, its texture's top towards -z) upright: facing +z
/// with the texture's top up, then by `yaw` radians around the y axis, counter-clockwise from above.
Node upright(Node node, double yaw);

/// Degrees to radians, for angles that are written by hand.
constexpr float degrees(double angle) {
  return float(angle * 3.14159265358979323846 / 180);
}

/// Plastic: a coloured body under a colourless gloss. Keeps diffuse + specular <= 1 by darkening the body a little.
Material plastic(std::string name, const glm::vec3& colour, float exponent = 64);

/// Metal: whatever it reflects is tinted by `reflectance`, the linear colour at normal incidence. There are no
/// surroundings to mirror, so a third is given to a diffuse part, tinted three times: light that a rough metal scatters
/// has bounced more than once.
Material metal(std::string name, const glm::vec3& reflectance, float exponent = 64);

/// Linear reflectances of metals at normal incidence, from measured indices of refraction (Akenine-Moller et al.,
/// "Real-Time Rendering", 4th edition, table 9.2).
inline constexpr glm::vec3 copper_reflectance{0.955f, 0.638f, 0.538f};
inline constexpr glm::vec3 gold_reflectance{1.0f, 0.782f, 0.344f};
inline constexpr glm::vec3 silver_reflectance{0.972f, 0.960f, 0.915f};

}  // namespace atelier
