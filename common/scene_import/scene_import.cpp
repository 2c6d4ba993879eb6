#include "scene_import/scene_import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "base/error.hpp"
#include "scene_import/frame.hpp"
#include "scene_import/gltf_scene.hpp"
#include "scene_import/obj_scene.hpp"

namespace atelier {
namespace {

using scene_import::Imported;
using scene_import::Notes;

Imported read(const std::filesystem::path& file, Notes& notes) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  if (ending == ".gltf" || ending == ".glb") return scene_import::read_gltf(file, notes);
  if (ending == ".obj") return scene_import::read_obj(file, notes);
  throw Error(fmt::format("{}: not a kind of file that can be imported (allowed: .gltf, .glb, .obj)", file.string()));
}

/// Adds a camera and a light if the file has none; completes the file's own camera.
void complete(Scene& scene, bool has_camera) {
  const Box3 box = bounds(scene);
  if (has_camera)
    scene_import::fit_depth(scene.camera, box);
  else
    scene.camera = scene_import::camera_around(box);
  if (!scene.lights.empty()) return;
  scene.lights.push_back(scene_import::key_light(scene.camera));
  scene.ambient = glm::vec3(0.12f);
  scene.background = glm::vec3(0.16f);  // grey, so that dark and light models are visible
}

bool has_triangles(const Scene& scene) {
  return std::ranges::any_of(scene.nodes,
                             [&](const Node& n) { return n.mesh && !scene.meshes[*n.mesh].indices.empty(); });
}

}  // namespace

Scene import_scene(const std::filesystem::path& file, std::vector<std::string>* notes) {
  Notes collected;
  Imported imported;
  try {
    imported = read(file, collected);
  } catch (const std::bad_alloc&) {
    throw Error(fmt::format("{}: there is not enough memory for this model", file.string()));
  }
  Scene& scene = imported.scene;
  scene.name = file.stem().string();
  if (!has_triangles(scene)) throw Error(fmt::format("{}: it has no triangles to draw", file.string()));
  complete(scene, imported.has_camera);
  try {
    validate(scene);
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", file.string(), error.what()));
  }
  if (notes) *notes = collected.sentences();
  return std::move(imported.scene);
}

}  // namespace atelier
