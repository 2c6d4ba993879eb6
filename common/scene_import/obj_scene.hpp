// A Wavefront OBJ file as a Scene.
#pragma once

#include "scene_import/gltf_scene.hpp"

namespace atelier::scene_import {

/// A mesh and a node for each object (or group) and material. Throws Error.
Imported read_obj(const std::filesystem::path& path, Notes& notes);

}  // namespace atelier::scene_import
