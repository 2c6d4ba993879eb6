// A glTF 2.0 file as a Scene: nodes, cameras and lights; meshes and materials come from their own readers.
#pragma once

#include <filesystem>

#include "scene/scene.hpp"
#include "scene_import/notes.hpp"

namespace atelier::scene_import {

/// What a reader hands over: the scene as the file has it, and whether it brought a camera.
struct Imported {
  Scene scene;
  bool has_camera = false;
};

/// The file's default scene (or its first, or all root nodes where it has none). Throws Error.
Imported read_gltf(const std::filesystem::path& path, Notes& notes);

}  // namespace atelier::scene_import
