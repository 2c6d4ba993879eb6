// glTF's skins: models in their rest pose, against numbers known beforehand and against the standard's formula.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "small_gltf.hpp"

using namespace atelier;
using atelier::test::bytes_of;
using atelier::test::error_of;
using atelier::test::import_document;
using atelier::test::mentions;
using nlohmann::json;

namespace {

constexpr int u8 = 5121, u16 = 5123, f32 = 5126;

template <class T>
std::string bytes_of_all(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// A glTF document that grows, with its one buffer.
struct Model {
  json document;
  std::string buffer;

  /// Adds an accessor over bytes of its own, and returns its index.
  int add(const std::string& bytes, int component, const char* type, std::size_t count, bool normalized = false) {
    document["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}});
    buffer += bytes;
    document["buffers"] = {{{"byteLength", buffer.size()}, {"uri", "triangle.bin"}}};
    document["accessors"].push_back({{"bufferView", document["bufferViews"].size() - 1},
                                     {"componentType", component},
                                     {"count", count},
                                     {"type", type},
                                     {"normalized", normalized}});
    return int(document["accessors"].size()) - 1;
  }

  json& attributes() { return document["meshes"][0]["primitives"][0]["attributes"]; }
  Scene import(std::vector<std::string>* notes = nullptr) const { return import_document(document, buffer, notes); }
};

const double quarter = std::sqrt(0.5);  // sine and cosine of half a quarter turn

/// An upright bar in the plane z = 0, two metres high, of six vertices in three rows. The two lower rows follow joint
/// `hip`, at the origin, the middle one to one half, and the upper ones joint `knee`, one metre above, which is turned
/// by 90 degrees about z. Its mesh's node is 50 m away, which must not matter.
Model bent_bar() {
  Model model;
  model.document = json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
    "nodes": [{"name": "bar", "mesh": 0, "skin": 0, "translation": [50, 0, 0]},
              {"name": "hip", "children": [2]},
              {"name": "knee", "translation": [0, 1, 0]}],
    "skins": [{"joints": [1, 2]}],
    "meshes": [{"primitives": [{"attributes": {}}]}]})");
  model.document["nodes"][2]["rotation"] = {0, 0, quarter, quarter};
  json& attributes = model.attributes();
  attributes["POSITION"] =
      model.add(bytes_of<float>({-.1f, 0, 0, .1f, 0, 0, -.1f, 1, 0, .1f, 1, 0, -.1f, 2, 0, .1f, 2, 0}), f32, "VEC3", 6);
  attributes["JOINTS_0"] = model.add(
      bytes_of<std::uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}), u8, "VEC4", 6);
  attributes["WEIGHTS_0"] =
      model.add(bytes_of<float>({1, 0, 0, 0, 1, 0, 0, 0, .5f, .5f, 0, 0, .5f, .5f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}), f32,
                "VEC4", 6);
  model.document["meshes"][0]["primitives"][0]["indices"] =
      model.add(bytes_of<std::uint16_t>({0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5}), u16, "SCALAR", 12);
  model.document["skins"][0]["inverseBindMatrices"] =
      model.add(bytes_of<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,  //
                                 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1}),
                f32, "MAT4", 2);
  return model;
}

void check_box(const Scene& scene, const glm::dvec3& low, const glm::dvec3& high) {
  const Box3 box = bounds(scene);
  INFO(box.low.x << " " << box.low.y << " " << box.low.z << " .. " << box.high.x << " " << box.high.y);
  const double tolerance = 4e-6;  // floats around 50
  CHECK(glm::length(box.low - low) < tolerance);
  CHECK(glm::length(box.high - high) < tolerance);
}

/// The corners of a scene's only mesh in the world, in the order of its indices.
std::vector<glm::dvec3> corners(const Scene& scene) {
  const auto world = world_matrices_exact(scene.nodes);
  std::vector<glm::dvec3> places;
  for (std::size_t n = 0; n < scene.nodes.size(); ++n)
    if (scene.nodes[n].mesh)
      for (const std::uint32_t i : scene.meshes[*scene.nodes[n].mesh].indices)
        places.emplace_back(world[n] * glm::dvec4(scene.meshes[*scene.nodes[n].mesh].vertices[i].position, 1));
  return places;
}

}  // namespace

TEST_CASE("a bar of two bones is bent as its joints are", "[scene_import]") {
  Model model = bent_bar();
  std::vector<std::string> notes;
  const Scene scene = model.import(&notes);
  CHECK(notes.empty());
  // The upper end (x, 2) goes to (-1, 1 + x), the middle (x, 1) to the mean of (x, 1) and (0, 1 + x).
  check_box(scene, {-1, 0, 0}, {.1, 1.1, 0});
  const std::vector<glm::dvec3> places = corners(scene);
  const glm::dvec3 expected[] = {{-.1, 0, 0}, {.1, 0, 0},     {-.05, .95, 0}, {-.05, .95, 0},
                                 {.1, 0, 0},  {.05, 1.05, 0}, {-.05, .95, 0}, {.05, 1.05, 0},
                                 {-1, .9, 0}, {-1, .9, 0},    {.05, 1.05, 0}, {-1, 1.1, 0}};
  REQUIRE(places.size() == std::size(expected));
  for (std::size_t i = 0; i < places.size(); ++i) CHECK(glm::length(places[i] - expected[i]) < 1e-6);
  for (const Vertex& vertex : scene.meshes.at(0).vertices) CHECK(vertex.normal.z == Approx(1));  // flat, bent in plane

  SECTION("what hangs on the mesh's node stays there") {
    model.document["nodes"].push_back({{"name", "hat"}, {"translation", {0, 3, 0}}});
    model.document["nodes"][0]["children"] = {3};
    CHECK(test::at(model.import(), "hat", {0, 0, 0}) == glm::dvec3(50, 3, 0));
  }
  SECTION("the matrices may lie at any byte, with gaps") {
    json& view = model.document["bufferViews"][4];
    const std::string matrices = model.buffer.substr(view["byteOffset"]);
    view["byteOffset"] = model.buffer.size() + 2;
    view["byteLength"] = 80 + 64;
    view["byteStride"] = 80;
    model.buffer += "xx" + matrices.substr(0, 64) + std::string(16, 'x') + matrices.substr(64);
    model.document["buffers"][0]["byteLength"] = model.buffer.size();
    check_box(model.import(), {-1, 0, 0}, {.1, 1.1, 0});
  }
  SECTION("a thousand kilometres away nothing is lost") {
    model.document["nodes"][1]["translation"] = {1e6 + 1. / 1024, 0, 0};
    check_box(model.import(), {1e6 + 1. / 1024 - 1, 0, 0}, {1e6 + 1. / 1024 + .1, 1.1, 0});
  }
  SECTION("without inverse bind matrices they are identities") {
    model.document["skins"][0].erase("inverseBindMatrices");
    // (x, 2) goes to (-2, 1 + x), the middle (x, 1) to the mean of (x, 1) and (-1, 1 + x).
    check_box(model.import(), {-2, 0, 0}, {.1, 1.1, 0});
  }
}

TEST_CASE("meshes share skins, and skins share meshes", "[scene_import]") {
  Model model = bent_bar();
  json& d = model.document;
  d["nodes"].push_back({{"name", "left"}, {"translation", {-10, 0, 0}}});
  SECTION("a mesh of two parts, and a second mesh, on one skin") {
    d["meshes"][0]["primitives"].push_back(d["meshes"][0]["primitives"][0]);
    d["meshes"].push_back(d["meshes"][0]);
    d["nodes"].push_back({{"mesh", 1}, {"skin", 0}});
    d["scenes"][0]["nodes"] = {0, 1, 4};
    const Scene scene = model.import();
    CHECK(scene.meshes.size() == 4);
    check_box(scene, {-1, 0, 0}, {.1, 1.1, 0});
  }
  SECTION("one mesh on two skins, and on none") {
    d["skins"].push_back({{"joints", {3, 3}}});
    d["nodes"].push_back({{"mesh", 0}, {"skin", 1}});
    d["nodes"].push_back({{"mesh", 0}, {"translation", {20, 0, 0}}});
    d["scenes"][0]["nodes"] = {0, 1, 3, 4, 5};
    const std::vector<glm::dvec3> places = corners(model.import());
    REQUIRE(places.size() == 36);  // the one without a skin comes first: it has no joints to wait for
    CHECK(glm::length(places[11] - glm::dvec3(20.1, 2, 0)) < 2e-6);
    CHECK(glm::length(places[23] - glm::dvec3(-1, 1.1, 0)) < 2e-6);
    CHECK(glm::length(places[35] - glm::dvec3(-9.9, 2, 0)) < 2e-6);
  }
}

namespace {

/// Joints, vertices and weights at random, and the standard's formula on them.
struct RandomFigure {
  static constexpr std::size_t joints = 5, vertices = 40;
  Model model = bent_bar();
  std::mt19937 random{7};
  std::vector<glm::dmat4> moves;  ///< W * IBM, by joint
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec4> tangents;
  std::vector<std::array<int, 8>> followed;
  std::vector<std::array<double, 8>> weights;

  double number(double low, double high) { return low + (high - low) * double(random()) / 4294967296.0; }
  glm::dvec3 vector() { return {number(-1, 1), number(-1, 1), number(-1, 1)}; }

  RandomFigure() {
    json& d = model.document;
    d["nodes"] = json::array({d["nodes"][0]});  // braces alone are a copy for some compilers
    d["scenes"][0]["nodes"] = {0, 1};
    d["skins"][0]["joints"] = json::array();
    std::vector<float> inverse;
    glm::dmat4 world(1);
    for (std::size_t j = 0; j < joints; ++j) {                                          // a chain
      const glm::dvec3 t = vector(), s(number(.5, 2), number(.5, 2), number(-2, -.5));  // every second one mirrors
      const glm::dquat q = glm::normalize(glm::dquat(number(-1, 1), vector()));
      d["nodes"].push_back(
          {{"translation", {t.x, t.y, t.z}}, {"scale", {s.x, s.y, s.z}}, {"rotation", {q.x, q.y, q.z, q.w}}});
      if (j + 1 < joints) d["nodes"].back()["children"] = json::array({j + 2});
      d["skins"][0]["joints"].push_back(j + 1);
      glm::dmat4 local = glm::mat4_cast(q);
      for (int c = 0; c < 3; ++c) local[c] *= s[c];
      local[3] = glm::dvec4(t, 1);
      world = world * local;
      glm::dmat4 bind(1);
      for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) {
          if (r < 3) bind[c][r] = float(bind[c][r] + number(-.4, .4));
          inverse.push_back(float(bind[c][r]));
        }
      moves.push_back(world * bind);
    }
    d["skins"][0]["inverseBindMatrices"] = model.add(bytes_of_all(inverse), f32, "MAT4", joints);
    for (std::size_t v = 0; v < vertices; ++v) {
      positions.emplace_back(vector());
      normals.emplace_back(glm::normalize(vector()));
      tangents.emplace_back(glm::normalize(vector()), v % 2 ? 1 : -1);
      followed.emplace_back();
      for (int& joint : followed.back()) joint = int(random() % joints);
    }
    json& attributes = model.attributes();
    attributes["POSITION"] = model.add(bytes_of_all(positions), f32, "VEC3", vertices);
    attributes["NORMAL"] = model.add(bytes_of_all(normals), f32, "VEC3", vertices);
    attributes["TANGENT"] = model.add(bytes_of_all(tangents), f32, "VEC4", vertices);
    d["meshes"][0]["primitives"][0].erase("indices");
  }

  /// Stores two sets of joints as J, and weights as W that sum to `one`, which is 1 for the standard.
  template <class J, class W>
  void store(int joint_type, int weight_type, double one) {
    weights.clear();
    for (int set = 0; set < 2; ++set) {
      std::vector<J> j;
      std::vector<W> w;
      for (std::size_t v = 0; v < vertices; ++v) {
        if (set == 0) {
          auto& all = weights.emplace_back();
          double left = one;
          for (std::size_t k = 0; k < 8; ++k) {
            all[k] = k == 7 ? left : double(W(left * number(0, .6)));
            left -= all[k];
          }
        }
        for (std::size_t k = 0; k < 4; ++k) {
          j.push_back(J(followed[v][4 * std::size_t(set) + k]));
          w.push_back(W(weights[v][4 * std::size_t(set) + k]));
        }
      }
      const std::string n = std::to_string(set);
      model.attributes()["JOINTS_" + n] = model.add(bytes_of_all(j), joint_type, "VEC4", vertices);
      model.attributes()["WEIGHTS_" + n] =
          model.add(bytes_of_all(w), weight_type, "VEC4", vertices, weight_type != f32);
    }
    for (auto& all : weights)
      for (double& weight : all) weight /= one;
  }

  glm::dmat4 blended(std::size_t v) const {
    glm::dmat4 sum(0);
    for (std::size_t k = 0; k < 8; ++k) sum += weights[v][k] * moves[std::size_t(followed[v][k])];
    return sum;
  }
};

}  // namespace

TEST_CASE("positions, normals and tangents follow the standard's formula", "[scene_import]") {
  struct Row {
    const char* name;
    std::function<void(RandomFigure&)> store;
  };
  const Row table[] = {
      {"bytes, floats", [](RandomFigure& f) { f.store<std::uint8_t, float>(u8, f32, 1); }},
      {"shorts, bytes", [](RandomFigure& f) { f.store<std::uint16_t, std::uint8_t>(u16, u8, 255); }},
      {"bytes, shorts", [](RandomFigure& f) { f.store<std::uint8_t, std::uint16_t>(u8, u16, 65535); }},
  };
  for (const Row& row : table) {
    INFO(row.name);
    RandomFigure figure;
    row.store(figure);
    std::vector<std::string> notes;
    const Scene scene = figure.model.import(&notes);
    CHECK(notes.empty());
    const Mesh& mesh = scene.meshes.at(0);
    const auto world = world_matrices_exact(scene.nodes);
    const auto holder = std::ranges::find_if(scene.nodes, [](const Node& node) { return node.mesh.has_value(); });
    const glm::dmat4& placed = world[std::size_t(holder - scene.nodes.begin())];
    REQUIRE(mesh.vertices.size() == RandomFigure::vertices);
    // Places are up to 50 m wide here, in floats; rotations pass through an axis and an angle in floats. A direction
    // loses more where the matrix nearly flattens it.
    const double tolerance = 1e-4;
    for (std::size_t v = 0; v < RandomFigure::vertices; ++v) {
      INFO("vertex " << v);
      const glm::dmat4 m = figure.blended(v);
      const glm::dvec3 p(placed * glm::dvec4(mesh.vertices[v].position, 1));
      CHECK(glm::length(p - glm::dvec3(m * glm::dvec4(figure.positions[v], 1))) < tolerance);
      const glm::dmat3 turn(m);
      const glm::dvec3 n = glm::normalize(glm::transpose(glm::inverse(turn)) * glm::dvec3(figure.normals[v]));
      CHECK(glm::length(glm::dvec3(mesh.vertices[v].normal) - n) < tolerance);
      const glm::dvec3 t = glm::normalize(turn * glm::dvec3(figure.tangents[v]));
      CHECK(glm::length(glm::dvec3(mesh.tangents.at(v)) - t) < tolerance);
      CHECK(mesh.tangents[v].w == figure.tangents[v].w * (glm::determinant(turn) < 0 ? -1 : 1));
    }
  }
}

TEST_CASE("a skin that mirrors keeps the outside outside", "[scene_import]") {
  Model model = bent_bar();
  model.document["nodes"][1]["scale"] = {-1, 1, 1};
  const std::vector<glm::dvec3> places = corners(model.import());
  for (std::size_t i = 0; i < places.size(); i += 3)
    CHECK(glm::cross(places[i + 1] - places[i], places[i + 2] - places[i]).z > 0);
}

TEST_CASE("defects of skins are mended, with a note", "[scene_import]") {
  // The bar's weights are floats 72 + 24 + 16 * vertex + 4 * k bytes into its buffer.
  const auto weight = [](Model& m, int vertex, float value) {
    m.buffer.replace(std::size_t(96 + 16 * vertex), 4, bytes_of({value}));
  };
  struct Row {
    const char* name;
    std::function<void(Model&)> change;
    std::vector<std::string_view> words;
    glm::dvec3 low, high;
  };
  const glm::dvec3 low(-1, 0, 0), high(.1, 1.1, 0);
  const Row table[] = {
      {"too much weight",
       [&](Model& m) { weight(m, 0, 3), weight(m, 5, .25f); },
       {"meshes[0].primitives[0]: 2 vertices", "do not sum to 1"},
       low,
       high},
      {"weights that are rounded", [&](Model& m) { weight(m, 0, .992f); }, {}, low, high},
      {"no weights",
       [&](Model& m) { weight(m, 1, 0); },
       {"meshes[0].primitives[0]: 1 vertices have no weights", "placed by the mesh's node"},
       low,
       {50.1, 1.1, 0}},
      {"a weight below 0",
       [&](Model& m) { weight(m, 2, -1); },
       {"1 weights", "negative or not finite"},
       {-1, 0, 0},
       {.1, 1.1, 0}},
      {"a weight without end",
       [&](Model& m) { weight(m, 2, INFINITY); },
       {"1 weights", "negative or not finite"},
       {-1, 0, 0},
       {.1, 1.1, 0}},
      {"no attributes",
       [](Model& m) { m.attributes().erase("JOINTS_0"), m.attributes().erase("WEIGHTS_0"); },
       {"6 vertices have no weights"},
       {49.9, 0, 0},
       {50.1, 2, 0}},
      {"joints alone",
       [](Model& m) { m.attributes().erase("WEIGHTS_0"); },
       {"6 vertices have no weights"},
       {49.9, 0, 0},
       {50.1, 2, 0}},
      {"weights alone",
       [](Model& m) { m.attributes().erase("JOINTS_0"); },
       {"6 vertices have no weights"},
       {49.9, 0, 0},
       {50.1, 2, 0}},
      {"fewer weights than vertices",
       [](Model& m) { m.document["accessors"][2]["count"] = 5; },
       {"accessors[2] (WEIGHTS_0)", "5 elements for 6 positions"},
       {49.9, 0, 0},
       {50.1, 2, 0}},
      {"a joint without weight that does not exist", [](Model& m) { m.buffer[75] = 9; }, {}, low, high},
      {"a joint outside the scene",
       [](Model& m) { m.document["nodes"][1].erase("children"); },
       {"skins[0]", "nodes[2] is not in the scene"},
       {49.9, 0, 0},
       {50.1, 2, 0}},
      {"a last row",
       [](Model& m) { m.buffer.replace(m.buffer.size() - 4, 4, bytes_of<float>({2})); },
       {"accessors[4]", "0 0 0 1"},
       low,
       high},
  };
  for (const Row& row : table) {
    INFO(row.name);
    Model model = bent_bar();
    row.change(model);
    std::vector<std::string> notes;
    check_box(model.import(&notes), row.low, row.high);
    std::string all;
    for (const std::string& note : notes) all += note + "\n";
    INFO(all);
    CHECK(notes.empty() == row.words.empty());
    for (const std::string_view word : row.words) CHECK(mentions(all, {"triangle.gltf: ", word}));
  }
}

TEST_CASE("broken skins are refused in one sentence that names the field", "[scene_import]") {
  struct Row {
    const char* name;
    std::function<void(Model&)> change;
    std::vector<std::string_view> words;
  };
  const Row table[] = {
      {"skin out of range", [](Model& m) { m.document["nodes"][0]["skin"] = 1; }, {"nodes[0].skin: index 1 of 1"}},
      {"no joints",
       [](Model& m) { m.document["skins"][0]["joints"] = json::array(); },
       {"skins[0].joints: 0 joints (allowed: at least 1)"}},
      {"joint out of range",
       [](Model& m) {
         m.document["skins"][0]["joints"] = {1, 3};
       },
       {"skins[0].joints[1]: index 3 of 3"}},
      {"a joint that the skin has not",
       [](Model& m) { m.buffer[72 + 4] = 2; },
       {"meshes[0].primitives[0]: vertex 1 follows joint 2 of 2 (skins[0].joints)"}},
      {"joints in a circle",
       [](Model& m) { m.document["nodes"][2]["children"] = {1}; },
       {"nodes[1]: the node has two parents, or is its own ancestor"}},
      {"fewer matrices than joints",
       [](Model& m) { m.document["accessors"][4]["count"] = 1; },
       {"accessors[4].count: 1 inverse bind matrices for 2 joints (allowed: 2..1000000)"}},
      {"more matrices than any skeleton needs",
       [](Model& m) {
         m.document["accessors"][4] = {{"count", 1e8}, {"componentType", f32}, {"type", "MAT4"}};
       },
       {"accessors[4].count: 100000000 inverse bind matrices"}},
      {"matrices of shorts",
       [](Model& m) { m.document["accessors"][4]["componentType"] = u16; },
       {"accessors[4].componentType: 5123 (allowed here: 5126)"}},
      {"matrices of four numbers",
       [](Model& m) { m.document["accessors"][4]["type"] = "VEC4"; },
       {"accessors[4]: 'VEC4' has 4 components (needed here: 16)"}},
      {"a matrix that is not finite",
       [](Model& m) { m.buffer.replace(m.buffer.size() - 8, 4, bytes_of<float>({NAN})); },
       {"skins[0].inverseBindMatrices: matrix 1 is not finite"}},
      {"matrices past their view",
       [](Model& m) { m.document["accessors"][4]["count"] = 3; },
       {"accessors[4]: 3 elements reach to byte 192 of a view of 128"}},
      {"joints as floats",
       [](Model& m) { m.attributes()["JOINTS_0"] = 2; },
       {"accessors[2].componentType: 5126 (allowed here: 5121, 5123, 5125)"}},
      {"joints one by one",
       [](Model& m) { m.document["accessors"][1]["type"] = "SCALAR"; },
       {"accessors[1]: 'SCALAR' has 1 components (needed here: 4)"}},
      {"a skin larger than floats",
       [](Model& m) {
         m.document["nodes"][1]["scale"] = {1e38, 1e38, 1e38}, m.document["nodes"][2]["scale"] = {9, 9, 9};
       },
       {"meshes[0].primitives[0]: the position of vertex", "not finite"}},
      {"33 joints for a vertex",
       [](Model& m) {
         for (int n = 1; n <= 8; ++n) {
           m.attributes()["JOINTS_" + std::to_string(n)] = 1;
           m.attributes()["WEIGHTS_" + std::to_string(n)] = 2;
         }
       },
       {"meshes[0].primitives[0].attributes: more than 8 sets of joints"}},
  };
  for (const Row& row : table) {
    INFO(row.name);
    Model model = bent_bar();
    row.change(model);
    const std::string message = error_of([&] { model.import(); });
    INFO(message);
    CHECK(mentions(message, {"triangle.gltf: "}));
    for (const std::string_view word : row.words) CHECK(mentions(message, {word}));
  }
}
