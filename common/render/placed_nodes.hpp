// A scene's nodes, ready to draw: meshes are uploaded once, matrices computed when they change.
#pragma once

#include <optional>
#include <vector>

#include "gl/objects.hpp"
#include "render/scene_painter.hpp"
#include "render/transforms.hpp"

namespace atelier {

class PlacedNodes {
 public:
  /// Uploads the meshes of a scene, which must outlive this. `tangents` are those of each mesh (Feature::tangents).
  PlacedNodes(Gl& gl, const TransformFunctions& transforms, const Scene& scene,
              const std::vector<std::vector<glm::vec4>>& tangents);

  /// Call it when nodes have moved.
  void moved() { placed_for_.reset(); }

  /// Computes all matrices for views that subtract `origin` from the world, unless they are up to date; returns how
  /// many it has computed. Throws Error if step 01's functions return another number of matrices.
  int place(bool camera_relative, const glm::dvec3& origin);

  /// Every node with a mesh.
  const std::vector<ScenePainter::Item>& items() const { return items_; }

  /// Draws the mesh of an item with the current program. A mirroring model matrix flips the winding; `mirrored` says
  /// whether the view does too.
  void draw(const ScenePainter::Item& item, bool mirrored) const;

 private:
  struct UploadedMesh {
    GlVertexArray vertex_array;
    GlBuffer vertex_buffer, index_buffer, tangent_buffer;
    GLsizei count = 0;
    Box3 box;  ///< object space
  };
  /// What the matrices depend on, beside the scene.
  struct Placement {
    bool camera_relative = false;
    glm::dvec3 origin{0};
    bool operator==(const Placement&) const = default;
  };

  UploadedMesh upload(const Mesh& mesh, const std::vector<glm::vec4>& tangents) const;
  glm::mat4 local_matrix(const Node& node, const Placement& placement) const;

  Gl& gl_;
  const TransformFunctions& transforms_;
  const Scene& scene_;
  std::vector<UploadedMesh> meshes_;
  std::vector<ScenePainter::Item> items_;
  std::optional<Placement> placed_for_;  ///< the placement for which `items_` was computed
};

}  // namespace atelier
