#include <cmath>
#include <functional>

#include "catch.hpp"
#include "scene_import/scene_import.hpp"
#include "small_gltf.hpp"

using namespace atelier;
using atelier::test::bytes_of;
using atelier::test::error_of;
using atelier::test::mentions;
using nlohmann::json;

namespace {

Scene import_document(const json& document, const std::string& buffer = test::triangle_buffer(),
                      std::vector<std::string>* notes = nullptr) {
  const TemporaryFolder folder;
  return import_scene(test::write_gltf(folder.path(), document, buffer), notes);
}

/// The document with something in it changed.
json changed(const std::function<void(json&)>& change) {
  json document = test::triangle_document();
  change(document);
  return document;
}

glm::dvec3 at(const Scene& scene, const char* node, const glm::dvec3& p) {
  const auto world = world_matrices_exact(scene.nodes);
  for (std::size_t i = 0; i < scene.nodes.size(); ++i)
    if (scene.nodes[i].name == node) return glm::dvec3(world[i] * glm::dvec4(p, 1));
  FAIL("no node " << node);
  return {};
}

}  // namespace

TEST_CASE("a triangle comes in from .gltf and .glb alike", "[scene_import]") {
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

TEST_CASE("cameras and lights stand where their nodes put them", "[scene_import]") {
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

TEST_CASE("what viewers forgive is mended, and said", "[scene_import]") {
  std::vector<std::string> notes;
  SECTION("normals that are no directions") {
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
  SECTION("a picture that is not there, and one outside the folder") {
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

TEST_CASE("broken glTF is refused in one sentence that names the field", "[scene_import]") {
  struct Row {
    const char* name;
    std::function<void(json&)> change;
    std::vector<std::string> words;
  };
  const Row table[] = {
      {"no asset", [](json& d) { d.erase("asset"); }, {"'asset' is missing"}},
      {"version 1", [](json& d) { d["asset"]["version"] = "1.0"; }, {"version '1.0'"}},
      {"version as number", [](json& d) { d["asset"]["version"] = 2.0; }, {"asset.version", "text"}},
      {"unknown extension", [](json& d) { d["extensionsRequired"] = {"X_y"}; }, {"'X_y'"}},
      {"scene out of range", [](json& d) { d["scene"] = 1; }, {"scene: index 1 of 1"}},
      {"node out of range", [](json& d) { d["scenes"][0]["nodes"] = {7}; }, {"scenes[0].nodes[0]: index 7 of 1"}},
      {"mesh out of range", [](json& d) { d["nodes"][0]["mesh"] = -1; }, {"nodes[0].mesh: index -1 of 1"}},
      {"mesh as text", [](json& d) { d["nodes"][0]["mesh"] = "0"; }, {"nodes[0].mesh", "string"}},
      {"fraction as index", [](json& d) { d["nodes"][0]["mesh"] = 0.5; }, {"index 0.5"}},
      {"own child", [](json& d) { d["nodes"][0]["children"] = {0}; }, {"nodes[0]", "ancestor"}},
      {"same child twice",
       [](json& d) {
         d["nodes"].push_back({{"name", "child"}}), d["nodes"][0]["children"] = {1, 1};
       },
       {"nodes[1]", "two parents"}},
      {"short matrix",
       [](json& d) {
         d["nodes"][0]["matrix"] = {1, 2, 3};
       },
       {"nodes[0].matrix: 3 elements"}},
      {"zero quaternion",
       [](json& d) {
         d["nodes"][0]["rotation"] = {0, 0, 0, 0};
       },
       {"length zero"}},
      {"translation beyond doubles",
       [](json& d) {
         d["nodes"][0]["translation"] = {1e300, 0, 0}, d["nodes"][0]["scale"] = {1e300, 1, 1};
       },
       {"finite"}},
      {"accessor out of range",
       [](json& d) { d["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 9; },
       {"POSITION: index 9 of 4"}},
      {"no count", [](json& d) { d["accessors"][0].erase("count"); }, {"accessors[0]", "'count' is missing"}},
      {"count zero", [](json& d) { d["accessors"][0]["count"] = 0; }, {"accessors[0].count: 0"}},
      {"count negative", [](json& d) { d["accessors"][0]["count"] = -3; }, {"accessors[0].count: -3"}},
      {"count huge", [](json& d) { d["accessors"][0]["count"] = 4e9; }, {"accessors[0].count"}},
      {"more vertices than allowed", [](json& d) { d["accessors"][0]["count"] = 60'000'000; }, {"50000000"}},
      {"past its view", [](json& d) { d["accessors"][0]["count"] = 7; }, {"accessors[0]", "view of 72"}},
      {"offset past its view", [](json& d) { d["accessors"][1]["byteOffset"] = 1u << 31; }, {"accessors[1]"}},
      {"view past its buffer", [](json& d) { d["bufferViews"][0]["byteLength"] = 105; }, {"bufferViews[0]", "105"}},
      {"view far past its buffer", [](json& d) { d["bufferViews"][0]["byteOffset"] = 1e12; }, {"bufferViews[0]"}},
      {"stride too small", [](json& d) { d["bufferViews"][0]["byteStride"] = 4; }, {"byteStride 4"}},
      {"no such component type", [](json& d) { d["accessors"][0]["componentType"] = 5124; }, {"5124"}},
      {"positions of two numbers", [](json& d) { d["accessors"][0]["type"] = "VEC2"; }, {"2 components"}},
      {"matrices as positions", [](json& d) { d["accessors"][0]["type"] = "MAT4"; }, {"'MAT4'"}},
      {"indices as floats",
       [](json& d) {
         d["accessors"][3]["componentType"] = 5126;
         d["accessors"][3]["count"] = 1;
       },
       {"unsigned"}},
      {"no data", [](json& d) { d["accessors"][0].erase("bufferView"); }, {"accessors[0]", "no data"}},
      {"buffer missing", [](json& d) { d["buffers"][0]["uri"] = "other.bin"; }, {"buffers[0].uri", "other.bin"}},
      {"buffer too short", [](json& d) { d["buffers"][0]["byteLength"] = 105; }, {"buffers[0]", "104 bytes"}},
      {"buffer above the folder", [](json& d) { d["buffers"][0]["uri"] = "../triangle.bin"; }, {"climbs out"}},
      {"buffer above, escaped", [](json& d) { d["buffers"][0]["uri"] = "%2e%2e/triangle.bin"; }, {"climbs out"}},
      {"absolute buffer", [](json& d) { d["buffers"][0]["uri"] = "/etc/passwd"; }, {"own folder"}},
      {"buffer from the net", [](json& d) { d["buffers"][0]["uri"] = "http://x/y.bin"; }, {"own folder"}},
      {"broken base64", [](json& d) { d["buffers"][0]["uri"] = "data:;base64,AA!A"; }, {"base64"}},
      {"data URI of text", [](json& d) { d["buffers"][0]["uri"] = "data:text/plain,hello"; }, {"base64"}},
      {"sparse element out of range",
       [](json& d) {
         d["accessors"][3]["sparse"] = {{"count", 1},
                                        {"indices", {{"bufferView", 0}, {"byteOffset", 12}, {"componentType", 5125}}},
                                        {"values", {{"bufferView", 2}}}};
       },
       {"sparse.indices", "of 3"}},
      {"material out of range", [](json& d) { d["meshes"][0]["primitives"][0]["material"] = 1; }, {"index 1 of 1"}},
      {"texture out of range",
       [](json& d) {
         d["materials"][0]["normalTexture"] = {{"index", 3}};
       },
       {"materials[0].normalTexture.index: index 3 of 0"}},
      {"mode out of range", [](json& d) { d["meshes"][0]["primitives"][0]["mode"] = 9; }, {"mode: 9"}},
      {"camera of 180 degrees",
       [](json& d) {
         d["cameras"] = json::parse(R"([{"type": "perspective", "perspective": {"yfov": 3.1416, "znear": 1}}])");
         d["nodes"][0]["camera"] = 0;
       },
       {"cameras[0].perspective.yfov", "179"}},
      {"light of an unknown type",
       [](json& d) {
         d["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "area"}}};
         d["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
       },
       {"'area'", "point, spot, directional"}},
  };
  for (const Row& row : table) {
    INFO(row.name);
    const std::string message = error_of([&] { import_document(changed(row.change)); });
    INFO(message);
    CHECK(mentions(message, {"triangle.gltf: "}));
    CHECK(message.find('\n') == std::string::npos);
    for (const std::string& word : row.words) CHECK(mentions(message, {word}));
  }
}

TEST_CASE("broken data in a sound document is refused, too", "[scene_import]") {
  std::string buffer = test::triangle_buffer();
  SECTION("index out of range") {
    buffer.replace(100, 2, bytes_of<std::uint16_t>({3}));
    CHECK(mentions(error_of([&] { import_document(test::triangle_document(), buffer); }),
                   {"meshes[0].primitives[0]", "index 3 of 3 vertices"}));
  }
  SECTION("positions that are not finite") {
    for (const float value : {NAN, INFINITY, -INFINITY}) {
      buffer.replace(16, 4, bytes_of({value}));
      CHECK(
          mentions(error_of([&] { import_document(test::triangle_document(), buffer); }), {"vertex 1", "not finite"}));
    }
  }
}

TEST_CASE("files that are no glTF are refused by their bytes", "[scene_import]") {
  const TemporaryFolder folder;
  const std::string glb = test::glb_bytes(test::triangle_document());
  std::string deep = R"({"asset": {"version": "2.0"}, "extras": )";
  for (int i = 0; i < 100'000; ++i) deep += '[';
  std::string longer = glb;
  longer[8] = char(longer[8] + 4);
  std::string far_chunk = glb;
  far_chunk[15] = 0x7f;
  struct Row {
    const char* name;
    const char* file;
    std::string bytes;
    const char* part;
  };
  const Row table[] = {
      {"empty", "a.gltf", "", "empty"},
      {"empty binary", "a.glb", "", "empty"},
      {"text", "a.gltf", "hello", "JSON"},
      {"half a document", "a.gltf", test::triangle_document().dump().substr(0, 300), "JSON"},
      {"an array", "a.gltf", "[1, 2]", "an object"},
      {"nested without end", "a.gltf", deep, "deeper than 64"},
      {"a number beyond doubles", "a.gltf", R"({"asset": {"version": "2.0"}, "scene": 1e999})", "out of range"},
      {"not UTF-8", "a.gltf", "{\"asset\": {\"version\": \"\xff\xfe\"}}", "JSON"},
      {"header alone", "a.glb", glb.substr(0, 12), "at least 20"},
      {"truncated in the JSON", "a.glb", glb.substr(0, 200), "truncated"},
      {"truncated in the data", "a.glb", glb.substr(0, glb.size() - 1), "truncated"},
      {"longer than it is", "a.glb", longer, "truncated"},
      {"a chunk past the end", "a.glb", far_chunk, "past the end"},
      {"no JSON chunk", "a.glb", "glTF" + bytes_of<std::uint32_t>({2, 20, 0, 0}), "without a JSON chunk"},
  };
  for (const Row& row : table) {
    INFO(row.name);
    write_file(folder.path() / row.file, row.bytes);
    const std::string message = error_of([&] { import_scene(folder.path() / row.file); });
    INFO(message);
    CHECK(mentions(message, {row.file, row.part}));
  }
  CHECK(mentions(error_of([&] { import_scene(folder.path() / "none.glb"); }), {"none.glb"}));
  CHECK(mentions(error_of([&] { import_scene(folder.path()); }), {folder.path().string(), ".gltf, .glb, .obj"}));
  std::filesystem::create_directory(folder.path() / "folder.glb");
  CHECK(mentions(error_of([&] { import_scene(folder.path() / "folder.glb"); }), {"folder.glb", "folder"}));
  write_file(folder.path() / "a.fbx", "x");
  CHECK(mentions(error_of([&] { import_scene(folder.path() / "a.fbx"); }), {"a.fbx", ".gltf, .glb, .obj"}));
}

TEST_CASE("a link that leads out of the model's folder is not followed", "[scene_import]") {
  const TemporaryFolder outside, inside;
  test::write_gltf(outside.path(), test::triangle_document());
  write_file(inside.path() / "a.gltf", test::triangle_document().dump());
  std::filesystem::create_symlink(outside.path() / "triangle.bin", inside.path() / "triangle.bin");
  CHECK(mentions(error_of([&] { import_scene(inside.path() / "a.gltf"); }), {"buffers[0].uri", "link"}));
}

TEST_CASE("a chain of 100 000 nodes is walked without recursion", "[scene_import]") {
  const json document = changed([](json& d) {
    for (int i = 0; i < 100'000; ++i) d["nodes"][i] = {{"children", {i + 1}}, {"translation", {0.001, 0, 0}}};
    d["nodes"].push_back({{"mesh", 0}, {"name", "corner"}});
  });
  const Scene scene = import_document(document);
  CHECK(at(scene, "corner", {0, 0, 0}).x == Approx(100).epsilon(1e-9));  // 1e5 additions in double
}

TEST_CASE("flipped bytes are answered with a scene or an Error, never otherwise", "[scene_import]") {
  const TemporaryFolder folder;
  const std::string glb = test::glb_bytes(test::triangle_document());
  std::uint32_t random = 12345;
  int refused = 0;
  for (int round = 0; round < 600; ++round) {
    std::string broken = glb;
    for (int flips = 0; flips < 1 + round % 4; ++flips) {
      random = random * 1664525u + 1013904223u;  // a linear congruential generator (Numerical Recipes)
      broken[(random >> 8) % broken.size()] = char(random >> 24);
    }
    write_file(folder.path() / "a.glb", broken);
    refused += !error_of([&] { import_scene(folder.path() / "a.glb"); }).empty();
  }
  CHECK(refused > 100);
}
