#include "render/placed_nodes.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.hpp"
#include "gl/debug.hpp"
#include "render/bind_viewpoint.hpp"

namespace atelier {

namespace {

/// Whether a matrix has a negative determinant. Its columns are normalised first: the product of three small scales
/// would underflow.
bool mirrors(const glm::mat4& model) {
  glm::mat3 m(model);
  for (int column = 0; column < 3; ++column) {
    const glm::vec3 size = glm::abs(m[column]);
    const float largest = std::max({size.x, size.y, size.z});
    if (largest > 0) m[column] /= largest;
  }
  return glm::determinant(m) < 0;
}

}  // namespace

PlacedNodes::PlacedNodes(Gl& gl, const TransformFunctions& transforms, const Scene& scene,
                         const std::vector<std::vector<glm::vec4>>& tangents)
    : gl_(gl), transforms_(transforms), scene_(scene) {
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) meshes_.push_back(upload(scene.meshes[i], tangents[i]));
  check_gl_error(gl_, "upload_mesh");  // check here, so that an error is reported in the right place
}

PlacedNodes::UploadedMesh PlacedNodes::upload(const Mesh& mesh, const std::vector<glm::vec4>& tangents) const {
  const MeshBuffers made = transforms_.upload_mesh(gl_, mesh.vertices, mesh.indices);
  UploadedMesh uploaded{.vertex_array = GlVertexArray(gl_, made.vertex_array),
                        .vertex_buffer = GlBuffer(gl_, made.vertex_buffer),
                        .index_buffer = GlBuffer(gl_, made.index_buffer),
                        .count = made.count,
                        .box = box_around(mesh)};
  if (!tangents.empty() && uploaded.vertex_array) {
    if (tangents.size() != mesh.vertices.size())
      throw Error(
          fmt::format("mesh '{}': {} tangents for {} vertices", mesh.name, tangents.size(), mesh.vertices.size()));
    uploaded.tangent_buffer = GlBuffer(gl_);
    gl_.BindVertexArray(uploaded.vertex_array.id());
    gl_.BindBuffer(GL_ARRAY_BUFFER, uploaded.tangent_buffer.id());
    gl_.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(tangents.size() * sizeof(glm::vec4)), tangents.data(), GL_STATIC_DRAW);
    gl_.EnableVertexAttribArray(attribute_tangent);
    gl_.VertexAttribPointer(attribute_tangent, 4, GL_FLOAT, GL_FALSE, sizeof(glm::vec4), nullptr);
  }
  label(gl_, GL_VERTEX_ARRAY, uploaded.vertex_array.id(), mesh.name);
  label(gl_, GL_BUFFER, uploaded.vertex_buffer.id(), mesh.name + ": vertices");
  label(gl_, GL_BUFFER, uploaded.index_buffer.id(), mesh.name + ": indices");
  label(gl_, GL_BUFFER, uploaded.tangent_buffer.id(), mesh.name + ": tangents");
  gl_.BindVertexArray(0);
  return uploaded;
}

glm::mat4 PlacedNodes::local_matrix(const Node& node, const Placement& placement) const {
  // Only roots are in world space: other nodes are close to their parent and need no double precision.
  const bool move = node.parent < 0 && placement.camera_relative;
  if (node.matrix) {
    glm::mat4 local = *node.matrix;
    if (move) local[3] = glm::vec4(transforms_.relative_to_eye(glm::dvec3(local[3]), placement.origin), 1);
    return local;
  }
  const glm::vec3 translation =
      move ? transforms_.relative_to_eye(node.translation, placement.origin) : glm::vec3(node.translation);
  return transforms_.compose(translation, node.rotation_axis, node.rotation_angle, node.scale);
}

int PlacedNodes::place(bool camera_relative, const glm::dvec3& origin) {
  const Placement wanted{camera_relative, origin};
  if (placed_for_ == wanted) return 0;
  placed_for_.reset();
  std::vector<Joint> joints;
  joints.reserve(scene_.nodes.size());
  for (const Node& node : scene_.nodes) joints.push_back({node.parent, local_matrix(node, wanted)});
  const std::vector<glm::mat4> world = transforms_.world_matrices(joints);
  if (world.size() != joints.size())
    throw Error(fmt::format("world_matrices returned {} matrices for {} nodes", world.size(), joints.size()));
  items_.clear();
  for (std::size_t i = 0; i < world.size(); ++i) {
    const Node& node = scene_.nodes[i];
    if (!node.mesh) continue;
    ScenePainter::Item item{int(i), world[i], transforms_.normal_matrix(world[i]), mirrors(world[i]),
                            meshes_[std::size_t(*node.mesh)].box};
    if (node.kept) item.kept = moved_plane(*node.kept, origin);
    items_.push_back(item);
  }
  placed_for_ = wanted;
  return int(world.size() + items_.size());
}

void PlacedNodes::draw(const ScenePainter::Item& item, bool mirrored) const {
  const UploadedMesh& mesh = meshes_[std::size_t(*scene_.nodes[std::size_t(item.node)].mesh)];
  if (!mesh.vertex_array || mesh.count <= 0) return;  // step 01's upload_mesh is not written yet: nothing to draw
  if (item.kept)
    gl_.Enable(GL_CLIP_DISTANCE1);
  else
    gl_.Disable(GL_CLIP_DISTANCE1);
  gl_.FrontFace(GLenum(item.mirrored != mirrored ? GL_CW : GL_CCW));
  gl_.BindVertexArray(mesh.vertex_array.id());
  if (mesh.index_buffer)
    gl_.DrawElements(GL_TRIANGLES, mesh.count, GL_UNSIGNED_INT, nullptr);
  else
    gl_.DrawArrays(GL_TRIANGLES, 0, mesh.count);
}

}  // namespace atelier
