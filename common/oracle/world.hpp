// A scene made ready for rays: every triangle and every shape in world space, in one tree of boxes.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "oracle/beam.hpp"
#include "oracle/bvh.hpp"
#include "oracle/shape.hpp"
#include "oracle/triangle.hpp"
#include "scene/scene.hpp"

namespace atelier::oracle {

/// What a ray sees: a point of a surface, ready to be shaded.
struct SurfacePoint {
  double t = 0;               ///< where along the ray
  glm::dvec3 position{0};     ///< world space, metres
  glm::dvec3 normal{0};       ///< interpolated, of unit length, or zero where there is none; on two-sided materials it
                              ///< is turned to the side that is seen
  glm::dvec3 flat_normal{0};  ///< square to the triangle, of unit length, on the side that is seen
  glm::dvec2 texcoord{0};
  int material = 0;  ///< index into Scene::materials
  int thing = 0;     ///< the node's index, or the number of nodes plus the shape's
  bool receives_shadow = true;
};

class World {
 public:
  /// Places the scene's nodes by world_matrices_exact, and the shapes beside them. Keeps a reference to the scene,
  /// which must outlive the world. Throws Error as validate() does, and where a shape's matrix cannot be inverted or
  /// its material is not one of the scene's.
  explicit World(const Scene& scene, std::vector<Shape> shapes = {});
  explicit World(Scene&& scene, std::vector<Shape> shapes = {}) = delete;  // it would not outlive the world

  const Scene& scene() const { return scene_; }

  /// The first point on the ray's stretch that is drawn there: faces that turn away are passed through unless their
  /// material is two-sided. A mirrored node's faces turn as OpenGL's do when the winding is swapped for it. Of things
  /// at one distance the first in the scene wins, as the depth test "less" has it.
  std::optional<SurfacePoint> seen(const Ray& ray) const;

  /// Whether anything that casts shadows meets the ray's stretch, whichever way it faces.
  bool blocked(const Ray& ray) const;

  // For many rays that go nearly the same way: first what any of them may meet, then ray by ray. A thing is a triangle
  // or a shape, by its index: those of the triangles come first.

  /// The things that cast shadows and that a ray of the beam may meet: all that any does, and few others.
  std::vector<std::uint32_t> casters_in(const Beam& beam) const;
  /// Whether a ray of the beam may meet the thing; false only where none does.
  bool may_meet(const Beam& beam, std::uint32_t thing) const;
  /// Whether the thing meets the ray's stretch, whichever way it faces.
  bool meets(const ShearedRay& ray, std::uint32_t thing) const;
  /// Whether a ray between others from the same point that the thing meets is met by it, too: true of all that is flat
  /// and convex.
  bool fills_between(std::uint32_t thing) const;

  /// The largest |coordinate| of anything in it, metres; 0 where there is nothing.
  double reach() const { return reach_; }
  std::size_t triangle_count() const { return triangles_.size(); }
  const Bvh& tree() const { return tree_; }

 private:
  struct Corner {
    glm::dvec3 position, normal;  ///< world space; the normal is of unit length or zero
    glm::dvec2 texcoord;
  };
  struct Triangle {
    std::uint32_t corners[3];  ///< counter-clockwise seen from the front
    int node;
  };
  struct PlacedShape {
    Shape shape;
    glm::dmat4 world_to_object;
    glm::dmat3 normal_matrix;
    Box3 box;  ///< around it, world space
  };
  struct Found;

  void place_nodes();
  void place_shapes(std::vector<Shape> shapes);
  void grow_tree();
  bool casts_shadow(std::uint32_t thing) const;
  std::array<glm::dvec3, 3> corners_of(const Triangle& triangle) const;
  Ray ray_in_object_space(const PlacedShape& placed, const Ray& ray) const;
  SurfacePoint point_on_triangle(const Triangle& triangle, const TriangleHit& hit) const;
  SurfacePoint point_on_shape(std::size_t index, const ShapeHit& hit, const Ray& ray) const;

  const Scene& scene_;
  std::vector<Corner> corners_;
  std::vector<Triangle> triangles_;
  std::vector<PlacedShape> shapes_;
  double reach_ = 0;
  Bvh tree_;  ///< over the triangles, then the shapes
};

/// The matrix that takes normals along with a surface: sign(det M) cofactor(M) of the upper left 3x3 block, scaled so
/// that its entries stay finite. Equals the inverse transpose up to a positive factor, and is there for flattened
/// models too. A determinant that is nothing but rounding counts as zero, and zero as positive.
glm::dmat3 normal_matrix_exact(const glm::dmat4& model);

}  // namespace atelier::oracle
