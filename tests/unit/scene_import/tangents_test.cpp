// Tangents of imported meshes: the file's, or the standard's where a normal map needs them.
#include "scene_import/tangents.hpp"

#include <cmath>

#include "image_io/image_io.hpp"
#include "scene/shapes.hpp"
#include "scene/standard_tangents.hpp"
#include "small_gltf.hpp"

using namespace atelier;
using atelier::test::bytes_of;
using atelier::test::changed;
using atelier::test::mentions;
using nlohmann::json;

namespace {

const WriteOptions data{.encoding = Encoding::data};
const Image bump(4, 4, {0.5f, 0.5f, 1, 1});

void add_normal_map(json& document) {
  document["images"] = {{{"uri", "normal.png"}}};
  document["textures"] = {{{"source", 0}}};
  document["materials"][0]["normalTexture"] = {{"index", 0}};
}

/// Tangents after the first 104 bytes of the triangle's buffer.
void add_tangents(json& document) {
  document["meshes"][0]["primitives"][0]["attributes"]["TANGENT"] = 4;
  document["accessors"].push_back({{"bufferView", 3}, {"componentType", 5126}, {"count", 3}, {"type", "VEC4"}});
  document["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 104}, {"byteLength", 48}});
  document["buffers"][0]["byteLength"] = 152;
}

Mesh import_with_picture(const json& document, const std::string& buffer, std::vector<std::string>& notes) {
  const TemporaryFolder folder;
  write_image(folder.path() / "normal.png", bump, data);
  return import_scene(test::write_gltf(folder.path(), document, buffer), &notes).meshes.at(0);
}

/// Two quads that share an edge, at which the texture is mirrored.
Mesh two_quads() {
  Mesh mesh;
  for (const float y : {0.0f, 1.0f})
    for (const float x : {-1.0f, 0.0f, 1.0f}) mesh.vertices.push_back({{x, y, 0}, {0, 0, 1}, {std::abs(x), y}});
  mesh.indices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
  return mesh;
}

}  // namespace

TEST_CASE("glTF: tangents come from the file, or are computed for a normal map", "[scene_import]") {
  const std::string given = bytes_of<float>({0, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1});
  const std::string invalid = bytes_of<float>({0, 1, 0, -1, 0, 0, 0, 1, 0, 1, 0, -1});
  struct Row {
    const char* name;
    bool map, in_file;
    std::string tangents;
    std::vector<glm::vec4> expected;
    std::size_t notes;
  };
  const std::vector<glm::vec4> computed(3, {1, 0, 0, 1}), read(3, {0, 1, 0, -1});
  const Row table[] = {
      {"neither", false, false, "", {}, 0},
      {"a map", true, false, "", computed, 0},
      {"tangents", false, true, given, read, 0},
      {"both", true, true, given, read, 0},
      {"invalid tangents", false, true, invalid, {}, 1},
      {"a map and invalid tangents", true, true, invalid, computed, 1},
  };
  for (const Row& row : table) {
    INFO(row.name);
    const json document = changed([&](json& d) {
      if (row.map) add_normal_map(d);
      if (row.in_file) add_tangents(d);
    });
    std::vector<std::string> notes;
    CHECK(import_with_picture(document, test::triangle_buffer() + row.tangents, notes).tangents == row.expected);
    REQUIRE(notes.size() == row.notes);
    if (!notes.empty()) CHECK(mentions(notes[0], {"tangents are left out", "vertex 1"}));
  }
}

TEST_CASE("glTF: without the picture of the normal map there are no tangents", "[scene_import]") {
  std::vector<std::string> notes;
  CHECK(test::import_document(changed(add_normal_map), test::triangle_buffer(), &notes).meshes.at(0).tangents.empty());
  CHECK(mentions(notes.at(0), {"normal.png"}));
}

TEST_CASE("OBJ: tangents are computed for a normal map alone", "[scene_import]") {
  const TemporaryFolder folder;
  write_image(folder.path() / "normal.png", bump, data);
  write_file(folder.path() / "model.mtl", "newmtl a\nnorm normal.png\nnewmtl b\nKd 1 0 0\n");
  write_file(folder.path() / "model.obj",
             "mtllib model.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 0 1\nvt 1 1\nvt 1 0\n"
             "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 3/3 4/4\n");
  const Scene scene = import_scene(folder.path() / "model.obj");
  REQUIRE(scene.meshes.size() == 2);
  CHECK(scene.meshes[0].tangents == std::vector<glm::vec4>(3, {0, 1, 0, -1}));  // u along y, v along x: mirrored
  CHECK(scene.meshes[1].tangents.empty());
}

TEST_CASE("vertices are split only where their corners have different tangents", "[scene_import]") {
  SECTION("a mirrored texture") {
    const Mesh before = two_quads();
    const std::vector<glm::vec4> corners = standard_tangents(before);
    Mesh mesh = before;
    scene_import::add_standard_tangents(mesh);
    REQUIRE(mesh.vertices.size() == 8);
    REQUIRE(mesh.tangents.size() == 8);
    CHECK(mesh.indices == std::vector<std::uint32_t>{0, 1, 4, 0, 4, 3, 6, 2, 5, 6, 5, 7});
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const std::uint32_t index = mesh.indices[c];
      CHECK(mesh.tangents[index] == corners[c]);
      CHECK(mesh.vertices[index].position == before.vertices[before.indices[c]].position);
      CHECK(mesh.vertices[index].texcoord == before.vertices[before.indices[c]].texcoord);
    }
    CHECK(mesh.tangents[1] == glm::vec4(-1, 0, 0, -1));
    CHECK(mesh.tangents[6] == glm::vec4(1, 0, 0, 1));
  }
  SECTION("a smooth texture, and a vertex that no triangle uses") {
    Mesh mesh = make_torus();
    mesh.vertices.push_back({{0, 0, 0}, {0, 1, 0}, {0, 0}});
    const Mesh before = mesh;
    scene_import::add_standard_tangents(mesh);
    CHECK(mesh.vertices.size() == before.vertices.size());
    CHECK(mesh.indices == before.indices);
    CHECK_NOTHROW(validate({.name = "torus", .meshes = {mesh}}));
  }
}

TEST_CASE("a mesh whose texture coordinates span no area gets no tangents", "[scene_import]") {
  Mesh mesh = two_quads();
  for (Vertex& vertex : mesh.vertices) vertex.texcoord.y = 2 * vertex.texcoord.x;
  scene_import::add_standard_tangents(mesh);
  CHECK(mesh.tangents.empty());
}

TEST_CASE("glTF: the scale of a normal texture changes its slopes", "[scene_import]") {
  const Image slanted(2, 2, {0.8f, 0.5f, 0.9f, 1});  // n = (0.6, 0, 0.8)
  const auto stored = [&](double scale) {
    const TemporaryFolder folder;
    write_image(folder.path() / "normal.png", slanted, data);
    const json document = changed([&](json& d) {
      add_normal_map(d);
      d["materials"][0]["normalTexture"]["scale"] = scale;
    });
    const Scene scene = import_scene(test::write_gltf(folder.path(), document, test::triangle_buffer()));
    return scene.textures[std::size_t(*scene.materials[0].normal_texture)].pixels.at(0, 0);
  };
  CHECK(stored(1).r == Approx(0.8).margin(0.002));  // of 8 bits
  CHECK(stored(0).r == Approx(0.5).margin(0.002));
  CHECK(stored(0).b == Approx(1).margin(0.002));
  CHECK(stored(2).r == Approx(0.5 + 0.5 * 1.2 / std::hypot(1.2, 0.8)).margin(0.003));
  CHECK(stored(-1).r == Approx(0.2).margin(0.002));
}
