// Checks that a scene can be drawn: one function per struct, each of which reports the first problem.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.hpp"
#include "scene/opening.hpp"
#include "scene/scene.hpp"

namespace atelier {
namespace {

/// Throws "scene 'hall': node 3 ('door'): ..."; stores the first two parts.
struct Context {
  std::string scene, thing;

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(fmt::format("scene '{}': {}: {}", scene, thing, what));
  }
  void require(bool holds, const char* what) const {
    if (!holds) fail(what);
  }
};

template <class Vector>
bool finite(const Vector& v) {
  for (int i = 0; i < Vector::length(); ++i)
    if (!std::isfinite(v[i])) return false;
  return true;
}

bool finite(const glm::mat4& m) {
  return finite(m[0]) && finite(m[1]) && finite(m[2]) && finite(m[3]);
}

bool finite_and_not_negative(const glm::vec3& v) {
  return finite(v) && v.x >= 0 && v.y >= 0 && v.z >= 0;
}

void check_index(const Context& context, const char* what, int index, std::size_t count) {
  if (index < 0 || std::size_t(index) >= count)
    context.fail(fmt::format("{} {} of {} (allowed: 0..{})", what, index, count, std::ptrdiff_t(count) - 1));
}

void check_mesh(const Context& context, const Mesh& mesh) {
  if (mesh.indices.size() % 3 != 0)
    context.fail(fmt::format("{} indices, which is not a multiple of 3", mesh.indices.size()));
  if (!mesh.tangents.empty() && mesh.tangents.size() != mesh.vertices.size())
    context.fail(fmt::format("{} tangents for {} vertices", mesh.tangents.size(), mesh.vertices.size()));
  for (const std::uint32_t index : mesh.indices)
    if (index >= mesh.vertices.size())
      context.fail(fmt::format("index {} of {} vertices", index, mesh.vertices.size()));
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vertex& v = mesh.vertices[i];
    if (!finite(v.position)) context.fail(fmt::format("vertex {}: the position is not finite", i));
    if (!finite(v.normal)) context.fail(fmt::format("vertex {}: the normal is not finite", i));
    if (!finite(v.texcoord)) context.fail(fmt::format("vertex {}: the texture coordinate is not finite", i));
  }
  for (const glm::vec4& tangent : mesh.tangents) context.require(finite(tangent), "a tangent is not finite");
}

void check_material(const Context& context, const Material& material, const Scene& scene) {
  context.require(finite_and_not_negative(material.diffuse), "diffuse must be finite and not negative");
  context.require(finite_and_not_negative(material.specular), "specular must be finite and not negative");
  context.require(finite_and_not_negative(material.emission), "emission must be finite and not negative");
  if (!(material.exponent >= 0 && material.exponent <= 1e6f))
    context.fail(fmt::format("exponent {} (allowed: 0..1000000)", material.exponent));
  for (const TextureIndex& texture :
       {material.diffuse_texture, material.specular_texture, material.normal_texture, material.height_texture})
    if (texture) check_index(context, "texture", *texture, scene.textures.size());
}

void check_texture(const Context& context, const Texture& texture) {
  context.require(!texture.pixels.empty(), "it has no pixels");
  for (const Rgba& p : texture.pixels.pixels())
    if (!(std::isfinite(p.r) && std::isfinite(p.g) && std::isfinite(p.b) && std::isfinite(p.a)))
      context.fail("a pixel is not finite");
}

void check_node(const Context& context, const Node& node, const Scene& scene) {
  context.require(finite(node.translation) && finite(node.scale), "translation and scale must be finite");
  context.require(finite(node.rotation_axis) && std::isfinite(node.rotation_angle), "the rotation must be finite");
  context.require(node.rotation_angle == 0 || node.rotation_axis != glm::vec3(0),
                  "the rotation's axis is zero but its angle is not");
  context.require(!node.matrix || finite(*node.matrix), "the matrix must be finite");
  context.require(!node.kept || finite(*node.kept), "the plane at which it ends must be finite");
  if (!node.mesh) return;
  check_index(context, "mesh", *node.mesh, scene.meshes.size());
  check_index(context, "material", node.material, scene.materials.size());
}

void check_light(const Context& context, const Light& light) {
  context.require(finite_and_not_negative(light.colour), "colour must be finite and not negative");
  if (light.type != LightType::point)
    context.require(finite(light.direction) && light.direction != glm::vec3(0),
                    "direction must be finite and not zero");
  if (light.type == LightType::directional) return;
  context.require(finite(light.position), "position must be finite");
  context.require(finite_and_not_negative(light.attenuation) && light.attenuation != glm::vec3(0),
                  "attenuation must be finite, not negative, and not all zero");
  if (light.type != LightType::spot) return;
  if (!(0 <= light.inner_angle && light.inner_angle <= light.outer_angle &&
        light.outer_angle <= std::numbers::pi_v<float>))
    context.fail(fmt::format("cone angles {} and {} radians (allowed: 0 <= inner <= outer <= pi)", light.inner_angle,
                             light.outer_angle));
}

/// Whether a matrix only rotates and translates, up to the rounding of nodes in single precision.
bool rigid(const glm::dmat4& m) {
  constexpr double rounding = 1e-5;
  const glm::dmat3 turn(m), product = glm::transpose(turn) * turn;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      if (!(std::abs(product[column][row] - (row == column ? 1 : 0)) <= rounding)) return false;
  return glm::determinant(turn) > 0;
}

/// A portal's mesh: flat, facing +z, in a rectangle that is centred on the frame up to rounding.
void check_opening(const Context& context, const Mesh& mesh) {
  constexpr double rounding = 1e-5;  // of vertices in single precision, of the rectangle's size
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high(-low);
  for (const Vertex& vertex : mesh.vertices) {
    if (vertex.position.z != 0)
      context.fail(fmt::format("the opening has a vertex at z = {} (allowed: 0)", vertex.position.z));
    low = glm::min(low, glm::dvec2(vertex.position));
    high = glm::max(high, glm::dvec2(vertex.position));
  }
  double area = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto corner = [&](std::size_t k) { return glm::dvec2(mesh.vertices[mesh.indices[i + k]].position); };
    const glm::dvec2 u = corner(1) - corner(0), v = corner(2) - corner(0);
    const double signed_area = (u.x * v.y - u.y * v.x) / 2;
    if (signed_area < 0)
      context.fail(fmt::format(
          "triangle {} of the opening faces -z (allowed: +z, corners counter-clockwise seen from there)", i / 3));
    area += signed_area;
  }
  context.require(area > 0, "the opening has no triangle with an area");
  for (int axis = 0; axis < 2; ++axis)
    if (std::abs(low[axis] + high[axis]) > rounding * (high[axis] - low[axis]))
      context.fail(fmt::format("the opening reaches from {0} = {1} to {2} (allowed: as far to either side of {0} = 0)",
                               axis == 0 ? 'x' : 'y', low[axis], high[axis]));
}

/// Whether a rectangle about the origin of `frame` lies in the plane z = 0 of another, up to rounding, and covers a
/// part of the rectangle about its origin. `to_other` is from the first frame to that of the other.
bool overlaps_in_plane(const glm::dmat4& to_other, const glm::dvec2& half_size, const glm::dvec2& other_half_size) {
  constexpr double rounding = 1e-5;
  const double largest = std::max({half_size.x, half_size.y, other_half_size.x, other_half_size.y});
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high(-low);
  for (const glm::dvec2& side : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
    const glm::dvec4 corner = to_other * glm::dvec4(side * half_size, 0, 1);
    if (std::abs(corner.z) > rounding * largest) return false;
    low = glm::min(low, glm::dvec2(corner));
    high = glm::max(high, glm::dvec2(corner));
  }
  const glm::dvec2 shared = glm::min(high, other_half_size) - glm::max(low, -other_half_size);
  return shared.x > rounding * largest && shared.y > rounding * largest;
}

/// No opening that can be seen from behind another portal's exit may cover a part of it in its plane: only rounding
/// would decide whether it is seen by who comes out there. (A portal's own may: then it leads straight on, and shows
/// the same once more.)
void check_exit_is_free(Context& context, const Scene& scene, const std::vector<glm::dmat4>& world,
                        const Portal& portal) {
  const int exit = portal.exit.value_or(portal.node);
  const glm::dmat4 to_exit = glm::inverse(world[std::size_t(exit)]);
  for (const Portal& other : scene.portals) {
    const glm::dmat4 to_exit_from_other = to_exit * world[std::size_t(other.node)];
    const bool faces_back = to_exit_from_other[2].z < 0;
    const bool two_sided = scene.materials[std::size_t(scene.nodes[std::size_t(other.node)].material)].two_sided;
    if (&other != &portal && other.node != exit && (faces_back || two_sided) &&
        overlaps_in_plane(to_exit_from_other, half_size_of(scene, other), half_size_of(scene, portal)))
      context.fail(fmt::format(
          "the opening of node {} ('{}') lies in the plane of the exit, node {} ('{}'), and covers a part of it "
          "(allowed: a distance between them, as between the two sides of a door)",
          other.node, scene.nodes[std::size_t(other.node)].name, exit, scene.nodes[std::size_t(exit)].name));
  }
}

void check_portals(Context& context, const Scene& scene) {
  if (scene.portals.empty()) return;
  const std::vector<glm::dmat4> world = world_matrices_exact(scene.nodes);
  const auto check_place = [&](const char* kind, int node) {
    check_index(context, kind, node, scene.nodes.size());
    if (!rigid(world[std::size_t(node)]))
      context.fail(fmt::format("{} {} ('{}') scales or mirrors (allowed: rotation and translation)", kind, node,
                               scene.nodes[std::size_t(node)].name));
  };
  for (std::size_t i = 0; i < scene.portals.size(); ++i) {
    const Portal& portal = scene.portals[i];
    context.thing = fmt::format("portal {}", i);
    check_place("node", portal.node);
    if (portal.exit) check_place("exit", *portal.exit);
    const Node& node = scene.nodes[std::size_t(portal.node)];
    for (std::size_t earlier = 0; earlier < i; ++earlier)
      if (scene.portals[earlier].node == portal.node)
        context.fail(fmt::format("portal {} is on node {} ('{}') too (allowed: one portal a node)", earlier,
                                 portal.node, node.name));
    context.require(node.mesh.has_value(), "its node has no mesh: the opening");
    check_opening(context, scene.meshes[std::size_t(*node.mesh)]);
    context.require(finite_and_not_negative(portal.colour), "colour must be finite and not negative");
  }
  for (std::size_t i = 0; i < scene.portals.size(); ++i) {
    context.thing = fmt::format("portal {}", i);
    check_exit_is_free(context, scene, world, scene.portals[i]);
  }
  context.thing = "camera";
  context.require(scene.camera.projection == Projection::perspective,
                  "an orthographic camera sees nothing through portals (allowed: a perspective one)");
}

void check_camera(const Context& context, const Camera& camera) {
  context.require(finite(camera.eye) && finite(camera.target), "eye and target must be finite");
  context.require(camera.eye != camera.target, "eye and target are the same point");
  context.require(finite(camera.up) && camera.up != glm::vec3(0), "up must be finite and not zero");
  context.require(std::isfinite(camera.near) && std::isfinite(camera.far) && camera.near < camera.far,
                  "near and far must be finite, near below far");
  if (camera.projection == Projection::orthographic) {
    context.require(std::isfinite(camera.height) && camera.height > 0, "height must be finite and above zero");
    return;
  }
  context.require(camera.near > 0, "near must be above zero in a perspective projection");
  // The limit is exactly 179 degrees; the tolerance allows for rounding in a conversion from degrees.
  constexpr float widest = 179.0f / 180.0f * std::numbers::pi_v<float> + 1e-6f;
  if (!(camera.fov_y > 0 && camera.fov_y <= widest))
    context.fail(
        fmt::format("vertical angle of view {} radians (allowed: above 0, at most 179 degrees)", camera.fov_y));
}

void check_sky(Context& context, const Sky& sky) {
  static constexpr std::array names = {"+x", "-x", "+y", "-y", "+z", "-z"};
  constexpr int longest = 4096;
  const int edge = sky.faces[0].width();
  for (std::size_t i = 0; i < sky.faces.size(); ++i) {
    const Image& face = sky.faces[i];
    context.thing = fmt::format("sky: face {} ({})", i, names[i]);
    if (face.width() != edge || face.height() != edge || edge < 1 || edge > longest)
      context.fail(fmt::format("{} x {} texels (allowed: six squares of one edge length, 1..{})", face.width(),
                               face.height(), longest));
    for (const Rgba& p : face.pixels())
      if (!(std::isfinite(p.r) && std::isfinite(p.g) && std::isfinite(p.b))) context.fail("a texel is not finite");
  }
}

}  // namespace

void validate(const Scene& scene) {
  Context context{scene.name, {}};
  const auto each = [&](const char* kind, const auto& list, const auto& check) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      context.thing = fmt::format("{} {} ('{}')", kind, i, list[i].name);
      check(list[i]);
    }
  };
  each("mesh", scene.meshes, [&](const Mesh& mesh) { check_mesh(context, mesh); });
  each("texture", scene.textures, [&](const Texture& texture) { check_texture(context, texture); });
  each("material", scene.materials, [&](const Material& material) { check_material(context, material, scene); });
  each("node", scene.nodes, [&](const Node& node) { check_node(context, node, scene); });
  each("light", scene.lights, [&](const Light& light) { check_light(context, light); });
  try {
    parents_first(scene.nodes);
  } catch (const Error& error) {
    throw Error(fmt::format("scene '{}': {}", scene.name, error.what()));
  }
  check_portals(context, scene);
  context.thing = "camera";
  check_camera(context, scene.camera);
  context.thing = "ambient";
  context.require(finite_and_not_negative(scene.ambient), "it must be finite and not negative");
  context.thing = "background";
  context.require(finite_and_not_negative(scene.background), "it must be finite and not negative");
  if (scene.sky) check_sky(context, *scene.sky);
}

}  // namespace atelier
