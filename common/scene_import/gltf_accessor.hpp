// glTF's accessors: typed arrays inside of buffers, dense or sparse, read into plain vectors.
#pragma once

#include <cstdint>
#include <vector>

#include "scene_import/gltf_file.hpp"

namespace atelier::scene_import {

/// How many elements accessors[index] has. Throws Error where that is no number from 1 to max_import_vertices * 3.
std::size_t accessor_count(const GltfFile& file, int index);

/// All elements of accessors[index] as floats, `components` each, one after the other; normalized integers become
/// fractions, others numbers. Throws Error where the accessor has another number of components, reaches out of its
/// view, or any other field is not as glTF 2.0 has it. NaN and infinity come through: what they mean is the caller's
/// business.
std::vector<float> read_accessor(const GltfFile& file, int index, int components);

/// All elements of a scalar accessor of unsigned integers.
std::vector<std::uint32_t> read_index_accessor(const GltfFile& file, int index);

}  // namespace atelier::scene_import
