// Imports one file and says how it went: what models_test.cpp starts as a child, so that a crash or an endless loop
// over one model costs one model.
#include <cstdio>

#include "base/error.hpp"
#include "scene_import/scene_import.hpp"

int main(int count, char** arguments) {
  if (count != 2) return atelier::exit_usage;
  try {
    std::vector<std::string> notes;
    const atelier::Scene scene = atelier::import_scene(arguments[1], &notes);
    std::size_t triangles = 0;
    for (const atelier::Mesh& mesh : scene.meshes) triangles += mesh.indices.size() / 3;
    std::printf("loaded: %zu triangles, %zu notes\n", triangles, notes.size());
    return atelier::exit_ok;
  } catch (const atelier::Error& error) {
    std::printf("refused: %s\n", error.what());
    return atelier::exit_usage;
  }
}
