// Invalid glTF files, and how they are refused.
#include <functional>

#include "catch.hpp"
#include "scene_import/scene_import.hpp"
#include "small_gltf.hpp"

using namespace atelier;
using atelier::test::at;
using atelier::test::bytes_of;
using atelier::test::changed;
using atelier::test::error_of;
using atelier::test::import_document;
using atelier::test::mentions;
using nlohmann::json;

TEST_CASE("broken glTF is refused in one sentence that names the field", "[scene_import]") {
  struct Row {
    const char* name;
    std::function<void(json&)> change;
    std::vector<std::string> words;
  };
  const Row table[] = {
      {"no asset", [](json& d) { d.erase("asset"); }, {"'asset' is missing"}},
      {"version 1", [](json& d) { d["asset"]["version"] = "1.0"; }, {"version '1.0'"}},
      {"a newer version", [](json& d) { d["asset"]["minVersion"] = "2.1"; }, {"version '2.1'"}},
      {"version as number",
       [](json& d) { d["asset"]["version"] = 1; },
       {"asset.version: the number 1 (allowed: \"2.x\""}},
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
       {"accessors[3].componentType: 5126 (allowed here: 5121, 5123, 5125)"}},
      {"data that are compressed",
       [](json& d) {
         d["accessors"][0].erase("bufferView");
         d["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = json::object();
       },
       {"meshes[0].primitives[0]", "KHR_draco_mesh_compression"}},
      {"buffer missing", [](json& d) { d["buffers"][0]["uri"] = "other.bin"; }, {"buffers[0].uri", "other.bin"}},
      {"buffer too short", [](json& d) { d["buffers"][0]["byteLength"] = 105; }, {"buffers[0]", "104 bytes"}},
      {"buffer above the folder",
       [](json& d) { d["buffers"][0]["uri"] = "../triangle.bin"; },
       {"is outside the model"}},
      {"a name that no system takes",
       [](json& d) { d["buffers"][0]["uri"] = std::string(300, 'a') + "/b.bin"; },
       {"not a path"}},
      {"buffer above, escaped",
       [](json& d) { d["buffers"][0]["uri"] = "%2e%2e/triangle.bin"; },
       {"is outside the model"}},
      {"absolute buffer", [](json& d) { d["buffers"][0]["uri"] = "/etc/passwd"; }, {"own folder"}},
      {"buffer from the net", [](json& d) { d["buffers"][0]["uri"] = "http://x/y.bin"; }, {"own folder"}},
      {"broken base64", [](json& d) { d["buffers"][0]["uri"] = "data:;base64,AA!A"; }, {"base64"}},
      {"base64 with line breaks",
       [](json& d) { d["buffers"][0]["uri"] = "data:;base64,AAAA\nAAAA"; },
       {"buffers[0].uri: broken base64 data: a line break after 4 characters (allowed: A-Z"}},
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

TEST_CASE("files that are not glTF are refused by their content", "[scene_import]") {
  const TemporaryFolder folder;
  const std::string glb = test::glb_bytes(test::triangle_document());
  std::string deep = R"({"asset": {"version": "2.0"}, "extras": )";
  for (int i = 0; i < 100'000; ++i) deep += '[';
  std::string longer = glb;
  longer[8] = char(longer[8] + 4);
  std::string shorter = glb;
  shorter[8] = char(shorter[8] - 4);
  std::string far_chunk = glb;
  far_chunk[15] = 0x7f;
  struct Row {
    const char* name;
    const char* file;
    std::string bytes;
    std::string part;
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
      {"a header that ends early", "a.glb", shorter, "the end of the file, byte " + std::to_string(glb.size() - 4)},
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

TEST_CASE("flipped bytes give a scene or an Error, nothing else", "[scene_import]") {
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
