// glTF's skins: vertices that follow joints instead of their mesh's node. A model is drawn in its rest pose, where its
// file's nodes place the joints; animations are left out.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene_import/gltf_file.hpp"

namespace atelier::scene_import {

/// A skin in its rest pose.
struct Skin {
  int index = 0;                   ///< in the file's skins
  std::vector<glm::dmat4> joints;  ///< for each joint its world matrix * its inverse bind matrix
  glm::dvec3 origin{0};            ///< where the first joint is, in the world
};

/// The world matrix of a glTF node, none if it is not in the scene.
using NodePlaces = std::function<const glm::dmat4*(int node)>;

/// Reads skins[index]. None, with a note, if one of its joints is not in the scene. Throws Error if it has no joints,
/// fewer inverse bind matrices than joints, or one that is not finite.
std::optional<Skin> read_skin(const GltfFile& file, int index, const NodePlaces& places);

/// A mesh on a node: what its vertices follow.
struct SkinnedNode {
  const Skin& skin;
  glm::dmat4 world;  ///< of the node: for vertices without weights, which do not follow the skin
};

/// How the vertices of a primitive follow the joints: a vertex is moved by the mean of its joints' matrices, each
/// weighted (glTF 2.0, "Skins"). Changes arrays of numbers as they lie in accessors. Results are in the world's axes,
/// relative to the skin's origin, so that floats suffice far from the world's.
class Skinning {
 public:
  /// Reads the attributes JOINTS_n and WEIGHTS_n of `count` vertices. Weights that do not sum to 1 are divided by their
  /// sum; those that are negative or not finite count as 0; a vertex without weights is placed by `node`; each with a
  /// note. Throws Error if a vertex follows a joint that the skin does not have. `node` must outlive this.
  Skinning(const GltfFile& file, const JsonField& primitive, std::size_t count, const SkinnedNode& node);

  void move_positions(std::vector<float>& positions) const;  ///< 3 numbers each
  /// 3 numbers each, turned by the inverse transpose: of length 1, or 0 where no direction is left.
  void turn_normals(std::vector<float>& normals) const;
  /// 4 numbers each: of length 1, or 0 where no direction is left. The sign changes where the matrix mirrors.
  void turn_tangents(std::vector<float>& tangents) const;
  /// Turns the order of corners of the triangles that are mirrored, so that they still face outwards.
  void turn_triangles(std::vector<std::uint32_t>& indices) const;

 private:
  struct Influence {
    std::uint32_t joint;
    float weight;
  };
  using Set = std::vector<Influence>;  ///< four for each vertex

  void read_set(const GltfFile& file, const JsonField& primitive, int n);
  void check_weights(const GltfFile& file, const JsonField& primitive);
  glm::dmat4 matrix(std::size_t vertex) const;

  const SkinnedNode& node_;
  std::size_t count_;
  std::vector<Set> sets_;
};

}  // namespace atelier::scene_import
