// glTF's accessors: typed arrays inside of buffers, dense or sparse, read into plain vectors.
#pragma once

#include <cstdint>
#include <vector>

#include "scene_import/gltf_file.hpp"

namespace atelier::scene_import {

/// How many elements accessors[index] has. Throws Error unless it is 1 to max_import_vertices * 3.
std::size_t accessor_count(const GltfFile& file, int index);

/// All elements of accessors[index] as floats, `components` each, one after the other; normalized integers become
/// fractions. Throws Error if the accessor has another number of components, exceeds its view, or violates glTF 2.0.
/// NaN and infinity are returned: the caller must check for them.
std::vector<float> read_accessor(const GltfFile& file, int index, int components);

/// All elements of a scalar accessor of unsigned integers.
std::vector<std::uint32_t> read_index_accessor(const GltfFile& file, int index);

}  // namespace atelier::scene_import
