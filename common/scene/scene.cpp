#include "scene/scene.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"

namespace atelier {
namespace {

/// Rotation about an axis by Rodrigues' formula, in double, because the ground truth uses it.
glm::dmat4 rotation_matrix(const Node& node) {
  if (node.rotation_angle == 0) return glm::dmat4(1);
  const glm::dvec3 k = glm::normalize(glm::dvec3(node.rotation_axis));
  const double s = std::sin(double(node.rotation_angle)), c = std::cos(double(node.rotation_angle));
  const double t = 1 - c;
  return glm::dmat4(glm::dvec4(t * k.x * k.x + c, t * k.x * k.y + s * k.z, t * k.x * k.z - s * k.y, 0),
                    glm::dvec4(t * k.x * k.y - s * k.z, t * k.y * k.y + c, t * k.y * k.z + s * k.x, 0),
                    glm::dvec4(t * k.x * k.z + s * k.y, t * k.y * k.z - s * k.x, t * k.z * k.z + c, 0),
                    glm::dvec4(0, 0, 0, 1));
}

glm::dmat4 local_matrix_exact(const Node& node) {
  if (node.matrix) return glm::dmat4(*node.matrix);
  glm::dmat4 m = rotation_matrix(node);
  for (int column = 0; column < 3; ++column) m[column] *= double(node.scale[column]);
  m[3] = glm::dvec4(node.translation, 1);
  return m;
}

}  // namespace

std::vector<int> parents_first(const std::vector<Node>& nodes) {
  const int count = int(nodes.size());
  enum class Mark : char { unseen, on_path, done };
  std::vector<Mark> marks(nodes.size(), Mark::unseen);
  std::vector<int> order, path;
  order.reserve(nodes.size());

  // From each node go up to the first ancestor that is already placed, then place the nodes on the way down. Without
  // recursion: a chain of a million nodes must not overflow the stack.
  for (int start = 0; start < count; ++start) {
    for (int i = start; i >= 0 && marks[i] != Mark::done; i = nodes[i].parent) {
      if (nodes[i].parent < -1 || nodes[i].parent >= count)
        throw Error(fmt::format("node {} ('{}'): parent {} of {} nodes (allowed: -1 for a root, or 0..{})", i,
                                nodes[i].name, nodes[i].parent, count, count - 1));
      if (marks[i] == Mark::on_path)
        throw Error(fmt::format("node {} ('{}') is its own ancestor: parents must not form a cycle", i, nodes[i].name));
      marks[i] = Mark::on_path;
      path.push_back(i);
    }
    for (; !path.empty(); path.pop_back()) {
      marks[path.back()] = Mark::done;
      order.push_back(path.back());
    }
  }
  return order;
}

std::vector<glm::dmat4> world_matrices_exact(const std::vector<Node>& nodes) {
  std::vector<glm::dmat4> world(nodes.size());
  for (const int i : parents_first(nodes)) {
    const glm::dmat4 local = local_matrix_exact(nodes[i]);
    world[i] = nodes[i].parent < 0 ? local : world[nodes[i].parent] * local;
  }
  return world;
}

Box3 bounds(const Scene& scene) {
  const std::vector<glm::dmat4> world = world_matrices_exact(scene.nodes);
  Box3 box;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i)
    if (scene.nodes[i].mesh) box.add(box_around(scene.meshes.at(*scene.nodes[i].mesh), world[i]));
  return box;
}

}  // namespace atelier
