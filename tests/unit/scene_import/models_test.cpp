// The importers on real models, valid and broken: Debian's packages assimp-testmodels and glmark2-data.
#include <algorithm>
#include <filesystem>
#include <map>

#include "base/process.hpp"
#include "catch.hpp"
#include "scene_import/scene_import.hpp"

using namespace atelier;
namespace fs = std::filesystem;

namespace {

const fs::path models = "/usr/share/assimp/models";
const fs::path bunny = "/usr/share/glmark2/models/bunny.obj";

/// What each file must give: the number of its triangles, or words of the refusal.
struct Expected {
  int triangles = 0;
  const char* refusal = nullptr;
};

const std::map<std::string, Expected>& expectations() {
  static const std::map<std::string, Expected> table = {
      {"OBJ/WusonOBJ.obj", {3732}},
      {"OBJ/box.obj", {12}},
      {"OBJ/box_UTF16BE.obj", {0, "UTF-16"}},
      {"OBJ/box_longline.obj", {944}},
      {"OBJ/box_mat_with_spaces.obj", {12}},
      {"OBJ/box_without_lineending.obj", {12}},
      {"OBJ/concave_polygon.obj", {64}},
      {"OBJ/cube_usemtl.obj", {12}},
      {"OBJ/number_formats.obj", {0, "number_formats.obj:11: '3.1+e2' is not a number"}},
      {"OBJ/point_cloud.obj", {0, "no triangles to draw"}},
      {"OBJ/regr01.obj", {2710}},
      {"OBJ/spider.obj", {1368}},
      {"OBJ/testline.obj", {0, "no triangles to draw"}},
      {"OBJ/testpoints.obj", {0, "no triangles to draw"}},
      {"invalid/empty.obj", {0, "the file is empty"}},
      {"invalid/malformed.obj", {0, "malformed.obj:28: vertex 0 of 8"}},
      {"glTF/BoxTextured-glTF/BoxTextured.gltf", {0, "version '1.0' (allowed: 2.x)"}},
      {"glTF/BoxTextured-glTF-Binary/BoxTextured.glb", {0, "version 1 (allowed: 2)"}},
      {"glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb", {75730}},
      {"glTF2/BoxBadNormals-glTF-Binary/BoxBadNormals.glb", {12}},
      {"glTF2/BoxTextured-glTF/BoxTextured.gltf", {12}},
      {"glTF2/BoxTextured-glTF-Embedded/BoxTextured.gltf", {12}},
      {"glTF2/BoxTextured-glTF-Binary/BoxTextured.glb", {12}},
      {"glTF2/BoxTextured-glTF-pbrSpecularGlossiness/BoxTextured.gltf", {12}},
      {"glTF2/BoxTextured-glTF-techniqueWebGL/BoxTextured.gltf", {0, "KHR_technique_webgl"}},
      {"glTF2/BoxWithInfinites-glTF-Binary/BoxWithInfinites.glb", {0, "the position of vertex 0 is not finite"}},
      {"glTF2/ClearCoat-glTF/ClearCoatTest.gltf", {37116}},
      {"glTF2/IndexOutOfRange/IndexOutOfRange.gltf", {0, "index 255 of 24 vertices"}},
      {"glTF2/MissingBin/BoxTextured.gltf", {0, "BoxTextured0.bin"}},
      {"glTF2/RecursiveNodes/RecursiveNodes.gltf", {0, "nodes[0]"}},
      {"glTF2/TestNoRootNode/NoScene.gltf", {0, "scene: index 0 of 0"}},
      {"glTF2/TestNoRootNode/SceneWithoutNodes.gltf", {0, "no triangles to draw"}},
      {"glTF2/draco/2CylinderEngine.gltf", {0, "KHR_draco_mesh_compression"}},
      {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_00.gltf", {0, "no triangles to draw"}},
      {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_04.gltf", {2}},
      {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_05.gltf", {2}},
      {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_06.gltf", {2}},
      {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_12.gltf", {2}},
      {"glTF2/simple_skin/simple_skin.gltf", {8}},
      {"glTF2/wrongTypes/badArray.gltf", {0, "meshes[0].primitives"}},
      {"glTF2/wrongTypes/badNumber.gltf", {0, "materials[0].normalTexture"}},
      {"glTF2/wrongTypes/badUint.gltf", {0, "index -1 of 1"}},
  };
  return table;
}

std::vector<fs::path> model_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(models)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".obj" || ending == ".gltf" || ending == ".glb") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

TEST_CASE("no model of assimp-testmodels crashes or hangs the importers", "[scene_import]") {
  if (!fs::exists(models)) SKIP_TEST("the package assimp-testmodels is not installed");
  std::size_t met = 0;
  for (const fs::path& file : model_files()) {
    INFO(file.string());
    // Twenty seconds: the largest takes one under sanitizers on a busy machine; a hang takes for ever.
    const Finished child = run_process(
        {.arguments = {ATELIER_TEST_PROGRAMS "/import_model", file.string()}, .time_limit = std::chrono::seconds(20)});
    INFO(child.output);
    CHECK_FALSE(child.timed_out);
    CHECK(child.signal == 0);
    const bool loaded = child.exit_status == 0, refused = child.exit_status == exit_usage;
    CHECK((loaded || refused));
    if (refused) CHECK(child.output.starts_with("refused: " + file.string()));

    const auto expected = expectations().find(file.lexically_relative(models).generic_string());
    if (expected == expectations().end()) continue;
    ++met;
    if (expected->second.refusal) {
      CHECK(refused);
      CHECK(child.output.find(expected->second.refusal) != std::string::npos);
    } else {
      CHECK(child.output.starts_with("loaded: " + std::to_string(expected->second.triangles) + " triangles"));
    }
  }
  CHECK(met == expectations().size());
}

TEST_CASE("the bunny is imported completely, smooth and in view", "[scene_import]") {
  if (!fs::exists(bunny)) SKIP_TEST("the package glmark2-data is not installed");
  const Scene scene = import_scene(bunny);
  REQUIRE(scene.meshes.size() == 1);
  CHECK(scene.meshes[0].indices.size() == 3 * 69666);
  CHECK(scene.lights.size() == 1);

  // Every vertex lies in the camera's cone and between its planes.
  const Camera& camera = scene.camera;
  const glm::dvec3 ahead = glm::normalize(camera.target - camera.eye);
  for (const Vertex& v : scene.meshes[0].vertices) {
    const glm::dvec3 to = glm::dvec3(v.position) - camera.eye;
    const double depth = glm::dot(to, ahead), aside = glm::length(to - depth * ahead);
    if (depth < camera.near || depth > camera.far || aside > depth * std::tan(camera.fov_y / 2)) FAIL("out of view");
  }
}
