// A scene as plain data, independent of how it is drawn. Shared by all code that draws, traces or imports scenes.
// Right-handed coordinates, metres, radians, +y up; colours are linear.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "scene/box.hpp"

namespace atelier {

/// One vertex of a mesh, laid out as in a vertex buffer.
struct Vertex {
  glm::vec3 position{0};  ///< object space, metres
  glm::vec3 normal{0};    ///< object space, unit length, pointing outwards
  glm::vec2 texcoord{0};  ///< (0,0) is the lower left corner of the texture, (1,1) the upper right
};

/// Indexed triangles, counter-clockwise seen from outside.
struct Mesh {
  std::string name;
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  ///< three per triangle, each below vertices.size()
  std::vector<glm::vec4> tangents;     ///< empty, or one per vertex: xyz along +u, w the bitangent's sign (as in glTF)
};

enum class Wrap { repeat, mirrored_repeat, clamp_to_edge };
enum class Filter { nearest, linear, mipmap };  ///< mipmap: linear magnification, trilinear minification

/// A picture on a surface. `pixels` are linear colours (already decoded from sRGB) or plain data, row 0 at the top.
struct Texture {
  std::string name;
  Image pixels;
  Wrap wrap = Wrap::repeat;
  Filter filter = Filter::mipmap;
};

/// A material's optional texture: an index into Scene::textures, or none.
using TextureIndex = std::optional<int>;

/// A Blinn-Phong material. All colours linear, 0..1 for materials that conserve energy.
struct Material {
  std::string name;
  glm::vec3 diffuse{0.8f};        ///< kd, the diffuse reflectance
  glm::vec3 specular{0.0f};       ///< ks, the colour of the highlight: grey for plastics, tinted for metals
  float exponent = 32.0f;         ///< n, the tightness of the highlight, 0 .. 1e6
  glm::vec3 emission{0.0f};       ///< emitted light
  TextureIndex diffuse_texture;   ///< multiplies `diffuse`
  TextureIndex specular_texture;  ///< multiplies `specular`
  TextureIndex normal_texture;    ///< tangent-space normals as n/2 + 1/2, green up
  TextureIndex height_texture;    ///< heights 0..1 in red
  bool two_sided = false;         ///< false: back faces are not drawn
};

/// A node of the hierarchy. Its matrix is translation * rotation * scale, applied after its parent's.
/// Translations are double, for scenes a million metres from the origin.
struct Node {
  std::string name;
  int parent = -1;                   ///< index into Scene::nodes, -1 for a root; any order, no cycles
  glm::dvec3 translation{0};         ///< metres, in the parent's space
  glm::vec3 rotation_axis{0, 1, 0};  ///< any length; must not be zero unless the angle is
  float rotation_angle = 0;          ///< radians, counter-clockwise seen with the axis towards the viewer
  glm::vec3 scale{1};                ///< zero and negative are allowed
  std::optional<glm::mat4> matrix;   ///< if set, replaces translation, rotation and scale (from imported files)
  std::optional<int> mesh;           ///< index into Scene::meshes; none: a group or a joint
  int material = 0;                  ///< index into Scene::materials
  bool casts_shadow = true, receives_shadow = true;
  bool travels = false;  ///< it and its children are a body that goes through portals
  /// If set, the node ends at a plane of the world, (n, d): only its points p with n.p + d >= 0 exist.
  std::optional<glm::dvec4> kept;
};

/// A way through an opening, from an entry to an exit; of a mirror both are the mirror.
struct Passage {
  int entry = 0, exit = 0;  ///< indices into Scene::nodes
  glm::dmat4 through{1};    ///< maps a point of the world to where it is after going through
  glm::dmat4 entry_to_world{1}, exit_to_world{1};
  glm::dvec2 half_size{0};  ///< of the rectangle around the opening, in the plane z = 0 of both frames, metres
};

enum class LightType { point, spot, directional };

/// A light without extent. Radiance at distance d from a point or spot light: colour * cone / (constant + linear d +
/// quadratic d^2); from a directional light: colour.
struct Light {
  LightType type = LightType::point;
  std::string name;
  glm::dvec3 position{0, 3, 0};    ///< world space; unused by directional lights
  glm::vec3 direction{0, -1, 0};   ///< world space, the direction in which the light travels; unused by point lights
  glm::vec3 colour{1};             ///< linear, may be above one
  glm::vec3 attenuation{0, 0, 1};  ///< constant, linear (1/m), quadratic (1/m^2); not all zero
  float inner_angle = 0.4f;        ///< radians from the axis: full intensity inside; 0 <= inner <= outer
  float outer_angle = 0.5f;        ///< radians from the axis: no light outside; at most pi
  bool casts_shadow = true;
  /// If set, this is the image of a light behind an exit: it shines through the opening alone. Features make such
  /// lights (Feature::add_lights); a scene has none.
  std::optional<Passage> passage;
  int image_of = -1;  ///< then the light's index in Scene::lights
};

enum class Projection { perspective, orthographic };

/// The view of the scene.
struct Camera {
  glm::dvec3 eye{0, 1, 5}, target{0};  ///< world space
  glm::vec3 up{0, 1, 0};
  Projection projection = Projection::perspective;
  float fov_y = 0.7853982f;      ///< full vertical field of view, radians, 0 < fov_y <= 179 degrees
  float height = 4;              ///< height of the view volume, metres, orthographic only
  float near = 0.1f, far = 100;  ///< metres, 0 < near < far (near may be negative when orthographic)
};

/// An opening through which another place of the scene is seen and entered, or a mirror. The node's mesh is the
/// opening: flat, in the plane z = 0 of the node, facing +z; the rectangle around it is centred on the node's origin. A
/// node has one portal at most. Neither its node nor the exit's may scale or mirror. Whoever goes through it from its
/// front moves along -z of the node, and comes out of the exit along the exit's +z, with the same way up: both nodes'
/// +z face the side on which the visitor is. If its material is two-sided, it is open from behind too: there one comes
/// out of the exit along its -z.
struct Portal {
  int node = 0;             ///< index into Scene::nodes
  std::optional<int> exit;  ///< index into Scene::nodes; none: a mirror
  glm::vec3 colour{0};      ///< what it shows where nothing is drawn in it, linear
};

/// What is infinitely far away in each direction: the faces of a cube, square pictures of one edge length, linear
/// colours (alpha is not used). Faces, columns and rows are in the order of OpenGL's cube maps. Along the columns s
/// increases, along the rows t:
///   face                    +x  -x  +y  -y  +z  -z
///   columns run towards     -z  +z  +x  +x  +x  -x
///   rows run towards        -y  -y  +z  -z  -y  -y
/// So row 0 of the four sides is at the top, as in any picture, and a face is the right way round from outside the
/// cube: seen from inside, left and right are exchanged.
struct Sky {
  std::array<Image, 6> faces;  ///< 1..4096 texels a side
};

struct Scene {
  std::string name;
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Node> nodes;
  std::vector<Light> lights;
  std::vector<Portal> portals;
  Camera camera;
  glm::vec3 ambient{0.03f};        ///< ambient light, linear
  glm::vec3 background{0.0f};      ///< background colour, linear
  std::shared_ptr<const Sky> sky;  ///< replaces the background colour; null: none. Copies of the scene share it
};

/// Throws atelier::Error naming the first problem, such as "scene 'hall': node 3 ('door'): mesh 9 of 4": an index out
/// of range, a cycle of parents, a NaN or infinity, a camera, light, portal or sky outside the ranges above.
void validate(const Scene& scene);

/// All node indices, every parent before its children, otherwise in the given order. Throws atelier::Error naming the
/// node for a cycle or a parent out of range. Linear time, no recursion.
std::vector<int> parents_first(const std::vector<Node>& nodes);

/// World matrices of all nodes, in double precision: the ground truth for step 01's world_matrices, and used by the
/// importers, bounds and the oracle. Throws atelier::Error for a cycle.
std::vector<glm::dmat4> world_matrices_exact(const std::vector<Node>& nodes);

/// The bounding box of everything drawn, in world space.
Box3 bounds(const Scene& scene);

}  // namespace atelier
