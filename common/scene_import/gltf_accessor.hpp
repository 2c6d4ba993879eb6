// glTF's accessors: typed arrays inside of buffers, dense or sparse, read into plain vectors.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene_import/gltf_file.hpp"

namespace atelier::scene_import {

/// How many elements accessors[index] has. Throws Error unless it is 1 to max_import_vertices * 3.
std::size_t accessor_count(const GltfFile& file, int index);

/// All elements of accessors[index] as floats, `components` each, one after the other; normalized integers become
/// fractions. Throws Error if the accessor has another number of components, exceeds its view, or violates glTF 2.0.
/// NaN and infinity are returned: the caller must check for them.
std::vector<float> read_accessor(const GltfFile& file, int index, int components);

/// All elements of an accessor of unsigned integers, `components` each, one after the other: indices, or joints.
std::vector<std::uint32_t> read_unsigned_accessor(const GltfFile& file, int index, int components);

/// All elements of a MAT4 accessor of floats. NaN and infinity are returned: the caller must check for them.
std::vector<glm::dmat4> read_matrix_accessor(const GltfFile& file, int index);

/// The accessor of a primitive's attribute; none if it is missing or, with a note, has another length than the
/// `count` positions.
std::optional<int> attribute(const GltfFile& file, const JsonField& primitive, const std::string& name,
                             std::size_t count);

}  // namespace atelier::scene_import
