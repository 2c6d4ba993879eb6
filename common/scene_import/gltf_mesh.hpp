// glTF's mesh primitives as Mesh.
#pragma once

#include <optional>

#include "scene/scene.hpp"
#include "scene_import/gltf_file.hpp"
#include "scene_import/gltf_materials.hpp"
#include "scene_import/gltf_skin.hpp"

namespace atelier::scene_import {

/// Vertices and triangles of all primitives of a file, checked against the limits.
struct Budget {
  std::size_t vertices = 0, triangles = 0;  ///< used so far
  /// Throws Error if the limits of scene_import.hpp are exceeded.
  void use(const JsonField& where, std::size_t more_vertices, std::size_t more_triangles);
};

/// The triangles of a primitive, with strips and fans converted; none if it has none (points, lines, no positions).
/// Texture coordinates are converted from glTF's (v down) to ours (v up) after `transform`. Missing normals become
/// flat, as the standard requires; invalid ones are fixed. With `skinned` the vertices follow its skin, and are
/// relative to the skin's origin in the world (Skinning); without (null) they are in the mesh's own space. Throws Error
/// for an index out of range or a position that is not finite.
std::optional<Mesh> read_primitive(const GltfFile& file, const JsonField& primitive, const TexcoordTransform& transform,
                                   const SkinnedNode* skinned, Budget& budget);

}  // namespace atelier::scene_import
