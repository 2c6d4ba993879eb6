// A scene as plain data: what there is to draw, with no word about how. Everything that draws, traces or imports a
// scene agrees on these structs alone. Right-handed coordinates, metres, radians, +y up; colours are linear.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "scene/box.hpp"

namespace atelier {

/// One corner of a mesh, as it lies in a vertex buffer.
struct Vertex {
  glm::vec3 position{0};  ///< object space, metres
  glm::vec3 normal{0};    ///< object space, unit length, out of the surface
  glm::vec2 texcoord{0};  ///< (0,0) is the lower left corner of the texture, (1,1) the upper right
};

/// Triangles over shared corners. Counter-clockwise seen from outside.
struct Mesh {
  std::string name;
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  ///< three a triangle, each below vertices.size()
  std::vector<glm::vec4> tangents;  ///< empty, or one a vertex: xyz along +u, w the sign of the bitangent (as in glTF)
};

enum class Wrap { repeat, mirrored_repeat, clamp_to_edge };
enum class Filter { nearest, linear, mipmap };  ///< mipmap: linear, with trilinear mipmaps when shrunk

/// A picture on a surface. `pixels` are linear colours (already decoded from sRGB) or plain data, row 0 at the top.
struct Texture {
  std::string name;
  Image pixels;
  Wrap wrap = Wrap::repeat;
  Filter filter = Filter::mipmap;
};

/// Where an optional picture of a material lies: an index into Scene::textures, or none.
using TextureIndex = std::optional<int>;

/// How a surface answers light: the Blinn-Phong model. All colours linear, 0..1 for materials that conserve energy.
struct Material {
  std::string name;
  glm::vec3 diffuse{0.8f};        ///< kd, the share of light that leaves diffusely
  glm::vec3 specular{0.0f};       ///< ks, the colour of the highlight: grey for plastics, tinted for metals
  float exponent = 32.0f;         ///< n, the tightness of the highlight, 0 .. 1e6
  glm::vec3 emission{0.0f};       ///< light that the surface gives off by itself
  TextureIndex diffuse_texture;   ///< multiplies `diffuse`
  TextureIndex specular_texture;  ///< multiplies `specular`
  TextureIndex normal_texture;    ///< tangent-space normals as n/2 + 1/2, green up
  TextureIndex height_texture;    ///< heights 0..1 in red
  bool two_sided = false;         ///< false: faces that turn away are not drawn
};

/// A node of the hierarchy. Its matrix is translation * rotation * scale, applied after its parent's.
/// Translations are double: a world may stand a million metres from its origin.
struct Node {
  std::string name;
  int parent = -1;                   ///< index into Scene::nodes, -1 for a root; any order, no cycles
  glm::dvec3 translation{0};         ///< metres, in the parent's space
  glm::vec3 rotation_axis{0, 1, 0};  ///< need not be unit length; must not be zero where the angle is not
  float rotation_angle = 0;          ///< radians, counter-clockwise seen against the axis
  glm::vec3 scale{1};                ///< zero and negative are allowed
  std::optional<glm::mat4> matrix;   ///< set: stands in for translation, rotation and scale (from imported files)
  std::optional<int> mesh;           ///< index into Scene::meshes; none: a group or a joint
  int material = 0;                  ///< index into Scene::materials
  bool casts_shadow = true, receives_shadow = true;
};

enum class LightType { point, spot, directional };

/// A light without extent. Radiance that arrives at distance d from a point or spot light:
/// colour * cone / (constant + linear d + quadratic d^2); from a directional light: colour.
struct Light {
  LightType type = LightType::point;
  std::string name;
  glm::dvec3 position{0, 3, 0};    ///< world space; unused by directional lights
  glm::vec3 direction{0, -1, 0};   ///< world space, the way that the light travels; unused by point lights
  glm::vec3 colour{1};             ///< linear, may be above one
  glm::vec3 attenuation{0, 0, 1};  ///< constant, linear (1/m), quadratic (1/m^2); not all zero
  float inner_angle = 0.4f;        ///< radians from the axis: full light within; 0 <= inner <= outer
  float outer_angle = 0.5f;        ///< radians from the axis: no light beyond; at most pi
  bool casts_shadow = true;
};

enum class Projection { perspective, orthographic };

/// From where the scene is seen.
struct Camera {
  glm::dvec3 eye{0, 1, 5}, target{0};  ///< world space
  glm::vec3 up{0, 1, 0};
  Projection projection = Projection::perspective;
  float fov_y = 0.7853982f;      ///< radians, the full vertical angle of view, 0 < fov_y <= 179 degrees
  float height = 4;              ///< metres seen from bottom to top, orthographic only
  float near = 0.1f, far = 100;  ///< metres, 0 < near < far (near may be negative when orthographic)
};

struct Scene {
  std::string name;
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Node> nodes;
  std::vector<Light> lights;
  Camera camera;
  glm::vec3 ambient{0.03f};    ///< light that arrives from everywhere, linear
  glm::vec3 background{0.0f};  ///< what is seen where nothing is
};

/// Throws atelier::Error naming the first thing that is wrong, as "scene 'hall': node 3 ('door'): mesh 9 of 4":
/// an index out of range, a cycle of parents, a NaN or infinity, a camera or light outside the ranges above.
void validate(const Scene& scene);

/// All node indices, every parent before its children, otherwise in the order given. Throws atelier::Error naming the
/// node at a cycle or a parent out of range. Takes time linear in the number of nodes, and no recursion.
std::vector<int> parents_first(const std::vector<Node>& nodes);

/// World matrices of all nodes, in double precision: the truth beside which step 01's own are judged, and what the
/// importers, bounds and the oracle use. Throws atelier::Error at a cycle.
std::vector<glm::dmat4> world_matrices_exact(const std::vector<Node>& nodes);

/// The box around everything that the scene draws, in world space.
Box3 bounds(const Scene& scene);

}  // namespace atelier
