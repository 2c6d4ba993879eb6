// Importing glTF files, and fixing errors that viewers tolerate.
#include <cmath>
#include <functional>

#include "catch.hpp"
#include "scene_import/scene_import.hpp"
#include "small_gltf.hpp"

using namespace atelier;
using atelier::test::at;
using atelier::test::bytes_of;
using atelier::test::changed;
using atelier::test::import_document;
using atelier::test::mentions;
using atelier::test::triangle_buffer;
using atelier::test::triangle_document;
using nlohmann::json;

TEST_CASE("a triangle is imported from .gltf and .glb", "[scene_import]") {
  const TemporaryFolder folder;
  test::write_gltf(folder.path(), test::triangle_document());
  write_file(folder.path() / "triangle.glb", test::glb_bytes(test::triangle_document()));
  for (const char* name : {"triangle.gltf", "triangle.glb"}) {
    INFO(name);
    const Scene scene = import_scene(folder.path() / name);
    CHECK(scene.name == "triangle");
    REQUIRE(scene.meshes.size() == 1);
    const Mesh& mesh = scene.meshes[0];
    CHECK(mesh.name == "tri");
    CHECK(mesh.indices == std::vector<std::uint32_t>{0, 1, 2});
    CHECK(mesh.vertices[1].position == glm::vec3(1, 0, 0));
    CHECK(mesh.vertices[1].normal == glm::vec3(0, 0, 1));
    // glTF's v runs down: (1, 1) is the lower right corner, ours (1, 0).
    CHECK(mesh.vertices[1].texcoord == glm::vec2(1, 0));
    REQUIRE(scene.materials.size() == 1);
    CHECK(scene.materials[0].diffuse.r == Approx(0.96));
    CHECK(scene.materials[0].specular.g == Approx(0.04));
    CHECK(scene.materials[0].exponent == Approx(2 / 0.0625 - 2));
    CHECK(scene.lights.size() == 1);
  }
}

TEST_CASE("nodes carry translation, rotation and scale, or a matrix", "[scene_import]") {
  const json document = changed([](json& d) {
    d["scenes"][0]["nodes"] = {2};
    d["nodes"].push_back({{"name", "child"}, {"children", {0}}, {"scale", {2, 2, 2}}, {"translation", {0, 0, 5}}});
    const double half = std::sqrt(0.5);  // a quarter turn about y: x goes to -z
    d["nodes"].push_back({{"name", "root"}, {"children", {1}}, {"rotation", {0, half, 0, half}}});
    d["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 10, 0, 0, 1};
  });
  const Scene scene = import_document(document);
  const double tolerance = 1e-5;  // axis and angle are floats, lengths around 20
  CHECK(glm::length(at(scene, "child", {0, 0, 0}) - glm::dvec3(5, 0, 0)) < tolerance);
  CHECK(glm::length(at(scene, "corner", {0, 0, 0}) - glm::dvec3(5, 0, -20)) < tolerance);
  CHECK(glm::length(at(scene, "corner", {1, 1, 0}) - glm::dvec3(5, 2, -22)) < tolerance);
}

TEST_CASE("strips, fans and missing indices become triangles", "[scene_import]") {
  const std::string quad = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
  struct Row {
    const char* name;
    int mode;
    std::vector<std::uint32_t> corners;  // positions of the triangles' corners, in the quad
  };
  const Row table[] = {{"triangles", 4, {0, 1, 2}}, {"strip", 5, {0, 1, 2, 2, 1, 3}}, {"fan", 6, {0, 1, 2, 0, 2, 3}}};
  for (const Row& row : table) {
    INFO(row.name);
    const json document = changed([&](json& d) {
      d["meshes"][0]["primitives"][0] = {{"attributes", {{"POSITION", 0}}}, {"mode", row.mode}};
      d["accessors"] = {{{"bufferView", 0}, {"componentType", 5126}, {"count", 4}, {"type", "VEC3"}}};
      d["bufferViews"] = {{{"buffer", 0}, {"byteLength", 48}}};
      d["buffers"][0]["byteLength"] = 48;
    });
    const Mesh mesh = import_document(document, quad).meshes.at(0);
    REQUIRE(mesh.indices.size() == row.corners.size());
    const glm::vec3 corners[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    for (std::size_t i = 0; i < row.corners.size(); ++i)
      CHECK(mesh.vertices[mesh.indices[i]].position == corners[row.corners[i]]);
    CHECK(mesh.vertices[0].normal == glm::vec3(0, 0, 1));  // made flat, by the winding
  }
}

TEST_CASE("normalized, strided and sparse accessors", "[scene_import]") {
  SECTION("texture coordinates as bytes, interleaved with padding") {
    const json document = changed([](json& d) {
      d["accessors"][2] = {
          {"bufferView", 1}, {"componentType", 5121}, {"normalized", true}, {"count", 3}, {"type", "VEC2"}};
      d["bufferViews"][1]["byteStride"] = 8;
    });
    std::string buffer = test::triangle_buffer();
    buffer.replace(72, 24, bytes_of<std::uint8_t>({0, 255, 9, 9, 9,  9, 9, 9, 255, 255, 9, 9,
                                                   9, 9,   9, 9, 51, 0, 9, 9, 9,   9,   9, 9}));
    const Mesh mesh = import_document(document, buffer).meshes.at(0);
    CHECK(mesh.vertices[0].texcoord == glm::vec2(0, 0));
    CHECK(mesh.vertices[2].texcoord.x == Approx(0.2));
    CHECK(mesh.vertices[2].texcoord.y == 1);
  }
  SECTION("a sparse accessor moves one position") {
    const json document = changed([](json& d) {
      d["accessors"][0]["sparse"] = {{"count", 1},
                                     {"indices", {{"bufferView", 2}, {"byteOffset", 4}, {"componentType", 5123}}},
                                     {"values", {{"bufferView", 0}, {"byteOffset", 12}}}};
    });
    const Mesh mesh = import_document(document).meshes.at(0);
    CHECK(mesh.vertices[2].position == glm::vec3(1, 0, 0));  // vertex 2 takes what vertex 1 has
    CHECK(mesh.vertices[1].position == glm::vec3(1, 0, 0));
  }
}

TEST_CASE("materials become Blinn-Phong", "[scene_import]") {
  struct Row {
    const char* name;
    json material;
    glm::vec3 diffuse, specular;
    float exponent;
  };
  const glm::vec3 base(1, 0.5f, 0.25f);
  const Row table[] = {
      {"plastic",
       json::parse(R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0.25, 1], "metallicFactor": 0}})"),
       0.96f * base, glm::vec3(0.04f), 0},
      {"metal",
       json::parse(R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0.25, 1], "roughnessFactor": 0.25}})"),
       glm::vec3(0), base, 2 / std::pow(0.25f, 4.0f) - 2},
      {"mirror", json::parse(R"({"pbrMetallicRoughness": {"roughnessFactor": 0}})"), glm::vec3(0), glm::vec3(1),
       10'000},
      {"the standard's default", json::object(), glm::vec3(0), glm::vec3(1), 0},
      {"glossy", json::parse(R"({"extensions": {"KHR_materials_pbrSpecularGlossiness":
          {"diffuseFactor": [0.5, 0.5, 0, 1], "specularFactor": [0.2, 0.1, 0.1], "glossinessFactor": 0.5}}})"),
       glm::vec3(0.4f, 0.4f, 0), glm::vec3(0.2f, 0.1f, 0.1f), 30},
  };
  for (const Row& row : table) {
    INFO(row.name);
    const Material material =
        import_document(changed([&](json& d) { d["materials"][0] = row.material; })).materials.at(0);
    for (int i = 0; i < 3; ++i) {
      CHECK(material.diffuse[i] == Approx(row.diffuse[i]).margin(1e-6));
      CHECK(material.specular[i] == Approx(row.specular[i]).margin(1e-6));
    }
    CHECK(material.exponent == Approx(row.exponent).epsilon(1e-5));  // floats raised to the fourth power
  }
}

TEST_CASE("cameras and lights have their nodes' transforms", "[scene_import]") {
  const json document = changed([](json& d) {
    d["scenes"][0]["nodes"] = {0, 1, 2, 3, 4};
    d["nodes"].push_back({{"camera", 0}, {"translation", {1, 2, 10}}});
    const double half = std::sqrt(0.5);  // a quarter turn about x that turns -z down
    d["nodes"].push_back({{"translation", {0, 4, 0}},
                          {"rotation", {-half, 0, 0, half}},
                          {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    d["nodes"].push_back({{"translation", {3, 0, 0}}, {"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
    d["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 2}}}}}});
    d["cameras"] = json::parse(R"([{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.1}}])");
    d["extensions"]["KHR_lights_punctual"]["lights"] = json::parse(R"([
      {"type": "spot", "intensity": 20, "color": [1, 0.5, 0], "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.4}},
      {"type": "point"}, {"type": "directional", "intensity": 2}])");
  });
  const Scene scene = import_document(document);
  const double tolerance = 1e-6;  // axis and angle are floats
  CHECK(glm::length(scene.camera.eye - glm::dvec3(1, 2, 10)) < tolerance);
  CHECK(glm::length(glm::normalize(scene.camera.target - scene.camera.eye) - glm::dvec3(0, 0, -1)) < tolerance);
  CHECK(scene.camera.fov_y == 0.7f);
  CHECK(scene.camera.near == 0.1f);
  CHECK(scene.camera.far > 11);  // endless in the file, beyond the triangle here
  REQUIRE(scene.lights.size() == 3);
  for (const Light& light : scene.lights) {
    switch (light.type) {
      case LightType::spot:
        CHECK(light.colour == glm::vec3(20, 10, 0));
        CHECK(glm::length(light.direction - glm::vec3(0, -1, 0)) < tolerance);
        CHECK(light.inner_angle == 0.1f);
        CHECK(light.outer_angle == 0.4f);
        break;
      case LightType::point:
        CHECK(glm::length(light.position - glm::dvec3(3, 0, 0)) < tolerance);
        break;
      case LightType::directional:
        CHECK(light.direction == glm::vec3(0, 0, -1));
        break;
    }
  }
}

TEST_CASE("nodes, cameras and lights come in the file's order", "[scene_import]") {
  json document = triangle_document();
  document["extensions"]["KHR_lights_punctual"]["lights"] =
      json::parse(R"([{"type": "point", "name": "red"}, {"type": "point", "name": "green"}])");
  document["cameras"] = json::parse(R"([
    {"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1, "zfar": 10}},
    {"type": "perspective", "perspective": {"yfov": 1.0, "znear": 0.1, "zfar": 10}}])");
  document["nodes"] = json::parse(R"([
    {"name": "a", "mesh": 0, "children": [1, 2]},
    {"name": "b", "camera": 1, "extensions": {"KHR_lights_punctual": {"light": 1}}},
    {"name": "c", "camera": 0, "extensions": {"KHR_lights_punctual": {"light": 0}}},
    {"name": "d", "mesh": 0}])");
  document["scenes"][0]["nodes"] = {0, 3};
  const Scene scene = import_document(document);
  std::string names;
  for (const Node& node : scene.nodes) names += node.name;
  CHECK(names == "abcd");
  CHECK(scene.camera.fov_y == 1.0f);
  REQUIRE(scene.lights.size() == 2);
  CHECK(scene.lights[0].name == "green");
}

TEST_CASE("what is left out of a glTF file is said, once a kind", "[scene_import]") {
  const struct {
    const char* note;
    std::function<void(json&)> change;
  } rows[] = {
      {"colours of vertices", [](json& d) { d["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 0; }},
      {"morph targets",
       [](json& d) { d["meshes"][0]["primitives"][0]["targets"] = json::parse(R"([{"POSITION": 0}])"); }},
      {"animations", [](json& d) { d["animations"] = json::parse(R"([{"channels": [], "samplers": []}])"); }},
      {"transparency", [](json& d) { d["materials"][0]["alphaMode"] = "BLEND"; }},
      {"metals", [](json& d) { d["materials"][0]["pbrMetallicRoughness"]["metallicFactor"] = 1; }},
      {"'KHR_materials_unlit'", [](json& d) { d["extensionsUsed"] = {"KHR_materials_unlit"}; }},
      {"'EXT_mesh_gpu_instancing'", [](json& d) { d["extensionsUsed"] = {"EXT_mesh_gpu_instancing"}; }},
      {"range of lights",
       [](json& d) {
         d["extensions"]["KHR_lights_punctual"]["lights"] = json::parse(R"([{"type": "point", "range": 2}])");
         d["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
       }},
  };
  for (const auto& row : rows) {
    INFO(row.note);
    json document = triangle_document();
    row.change(document);
    document["meshes"].push_back(document["meshes"][0]);  // twice, and said once
    document["nodes"].push_back({{"mesh", 1}});
    document["scenes"][0]["nodes"] = {0, 1};
    std::vector<std::string> notes;
    import_document(document, triangle_buffer(), &notes);
    REQUIRE(notes.size() == 1);
    CHECK(mentions(notes[0], {row.note}));
  }
}

TEST_CASE("an accessor without data is all zeros", "[scene_import]") {
  json document = triangle_document();
  document["accessors"][2].erase("bufferView");
  const Mesh mesh = import_document(document).meshes.at(0);
  for (const Vertex& vertex : mesh.vertices)
    CHECK(vertex.texcoord == glm::vec2(0, 1));  // rows count from the top there
}

TEST_CASE("errors that viewers tolerate are fixed, with a note", "[scene_import]") {
  std::vector<std::string> notes;
  SECTION("invalid normals") {
    std::string buffer = test::triangle_buffer();
    buffer.replace(36, 24, bytes_of<float>({0, 0, 0, NAN, 0, 0}));
    const Mesh mesh = import_document(test::triangle_document(), buffer, &notes).meshes.at(0);
    for (const Vertex& v : mesh.vertices) CHECK(v.normal == glm::vec3(0, 0, 1));
    REQUIRE(notes.size() == 1);
    CHECK(mentions(notes[0], {"2 normals"}));
  }
  SECTION("an attribute of another length") {
    const json document = changed([](json& d) { d["accessors"][1]["count"] = 2; });
    const Mesh mesh = import_document(document, test::triangle_buffer(), &notes).meshes.at(0);
    CHECK(mesh.vertices[0].normal == glm::vec3(0, 0, 1));
    CHECK(mentions(notes.at(0), {"accessors[1] (NORMAL)", "2 elements for 3 positions"}));
  }
  SECTION("a missing picture, and one outside the folder") {
    for (const char* uri : {"missing.png", "../secret.png", "/etc/passwd", "https://example.org/a.png"}) {
      const json document = changed([&](json& d) {
        d["images"] = {{{"uri", uri}}};
        d["textures"] = {{{"source", 0}}};
        d["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
      });
      const Scene scene = import_document(document, test::triangle_buffer(), &notes);
      CHECK(scene.textures.empty());
      CHECK_FALSE(scene.materials.at(0).diffuse_texture);
      REQUIRE(notes.size() == 1);
      CHECK(mentions(notes[0], {uri}));
    }
  }
}
