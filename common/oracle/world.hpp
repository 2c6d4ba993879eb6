// A scene prepared for ray tracing: all triangles and shapes in world space, in one BVH.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "oracle/beam.hpp"
#include "oracle/bvh.hpp"
#include "oracle/light_image.hpp"
#include "oracle/shape.hpp"
#include "oracle/triangle.hpp"
#include "scene/scene.hpp"

namespace atelier::oracle {

/// A visible surface point, ready for shading.
struct SurfacePoint {
  double t = 0;            ///< ray parameter
  glm::dvec3 position{0};  ///< world space, metres
  /// Interpolated, of unit length, or zero if there is none; flipped to the visible side on two-sided materials. Of a
  /// height field whose material has a normal texture: the rectangle's, because such a map stores the relief's normals
  /// relative to it; without one the relief's.
  glm::dvec3 normal{0};
  double normal_length = 1;  ///< of the interpolated normal, at most 1: the vertices' normals have unit length
  glm::dvec4 tangent{0};     ///< world space: along +u, interpolated between unit vectors; w as in tangents.hpp. Turned
                             ///< round like the normal. On rectangles and height fields along half_u. 0 where there is
                             ///< none: on other shapes, and where the material has no normal texture
  glm::dvec3 flat_normal{0};  ///< geometric normal, of unit length, on the visible side
  glm::dvec2 texcoord{0};
  int material = 0;  ///< index into Scene::materials
  int thing = 0;     ///< the node's index, or the number of nodes plus the shape's index
  bool receives_shadow = true;
};

class World {
 public:
  /// Transforms the scene's nodes with world_matrices_exact, and adds the shapes. Keeps a reference to the scene, which
  /// must outlive the world. Throws Error as validate() does, and if a shape's matrix cannot be inverted, its material
  /// is not one of the scene's, or it is a height field that is not valid (oracle/height_field.hpp).
  explicit World(const Scene& scene, std::vector<Shape> shapes = {});
  explicit World(Scene&& scene, std::vector<Shape> shapes = {}) = delete;  // a temporary would not outlive the world

  const Scene& scene() const { return scene_; }
  const std::vector<LightImage>& images() const { return images_; }  ///< of the scene's lights, in its openings

  /// The first visible point in the ray's interval: back faces are ignored unless their material is two-sided. For a
  /// mirrored node front and back are as in OpenGL with the winding swapped. At equal distance the first in the scene
  /// wins, as with the depth test GL_LESS.
  std::optional<SurfacePoint> seen(const Ray& ray) const;

  /// Whether a shadow caster, front or back face, intersects the ray's interval.
  bool blocked(const Ray& ray) const;

  // For many rays in nearly the same direction: first find what any of them may hit, then test single rays. A thing is
  // the index of a triangle or, after all triangles, of a shape.

  /// The shadow casters that a ray of the beam may hit: conservative, with few false positives.
  std::vector<std::uint32_t> casters_in(const Beam& beam) const;
  /// Whether a ray of the beam may hit the thing; false only if none does.
  bool may_meet(const Beam& beam, std::uint32_t thing) const;
  /// Whether the thing, front or back face, intersects the ray's interval.
  bool meets(const ShearedRay& ray, std::uint32_t thing) const;
  /// Whether the thing is planar and convex: if it blocks rays from one point, it also blocks all rays between them.
  bool fills_between(std::uint32_t thing) const;

  /// The largest |coordinate| in it, metres; 0 if it is empty.
  double reach() const { return reach_; }
  std::size_t triangle_count() const { return triangles_.size(); }
  const Bvh& tree() const { return tree_; }

 private:
  struct Corner {
    // World space. Normal and tangent are of unit length or zero; where a node is cut off, they are interpolated.
    glm::dvec3 position, normal;
    glm::dvec2 texcoord;
    glm::dvec4 tangent;
  };
  struct Triangle {
    std::uint32_t corners[3];  ///< counter-clockwise seen from the front
    int node;
  };
  struct PlacedShape {
    Shape shape;
    glm::dmat4 world_to_object;
    glm::dmat3 normal_matrix;
    Box3 box;            ///< bounding box, world space
    glm::dvec4 tangent;  ///< world space, seen from the front; 0 if there is none
  };
  struct Found;

  void place_nodes();
  void add_triangle(const Triangle& triangle);
  void place_shapes(std::vector<Shape> shapes);
  void build_tree();
  glm::dvec4 tangent_of(const Shape& shape) const;
  bool casts_shadow(std::uint32_t thing) const;
  std::array<glm::dvec3, 3> corners_of(const Triangle& triangle) const;
  Ray ray_in_object_space(const PlacedShape& placed, const Ray& ray) const;
  SurfacePoint point_on_triangle(const Triangle& triangle, const TriangleHit& hit) const;
  SurfacePoint point_on_shape(std::size_t index, const ShapeHit& hit, const Ray& ray) const;

  const Scene& scene_;
  std::vector<LightImage> images_;
  std::vector<Corner> corners_;
  std::vector<Triangle> triangles_;
  std::vector<PlacedShape> shapes_;
  double reach_ = 0;
  Bvh tree_;  ///< over the triangles, then the shapes
};

/// The normal matrix: sign(det M) cofactor(M) of the upper left 3x3 block, scaled so that its entries stay finite.
/// Equals the inverse transpose up to a positive factor, and also exists for flattened models. A determinant within
/// rounding error counts as zero, and zero as positive.
glm::dmat3 normal_matrix_exact(const glm::dmat4& model);

}  // namespace atelier::oracle
