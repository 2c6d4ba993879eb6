// A glTF 2.0 file as a Scene: nodes, cameras and lights; other files read meshes and materials.
#pragma once

#include <filesystem>

#include "scene/scene.hpp"
#include "scene_import/notes.hpp"

namespace atelier::scene_import {

/// A reader's result: the file's scene, and whether it has a camera.
struct Imported {
  Scene scene;
  bool has_camera = false;
};

/// The file's default scene (or its first, or all root nodes if it has no scene). Throws Error.
Imported read_gltf(const std::filesystem::path& path, Notes& notes);

}  // namespace atelier::scene_import
