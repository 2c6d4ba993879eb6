#include <cmath>

#include "base/file.hpp"
#include "catch.hpp"
#include "image_io/image_io.hpp"
#include "scene_import/polygon.hpp"
#include "scene_import/scene_import.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;

namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Scene import_text(const std::string& obj, const std::string& mtl = "", std::vector<std::string>* notes = nullptr) {
  const TemporaryFolder folder;
  write_file(folder.path() / "model.obj", obj);
  if (!mtl.empty()) write_file(folder.path() / "model.mtl", mtl);
  return import_scene(folder.path() / "model.obj", notes);
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const auto p = [&](int i) { return glm::dvec3(mesh.vertices[mesh.indices[t + i]].position); };
    sum += glm::length(glm::cross(p(1) - p(0), p(2) - p(0))) / 2;
  }
  return sum;
}

}  // namespace

TEST_CASE("faces of every OBJ form are imported", "[scene_import]") {
  struct Row {
    const char* name;
    std::string text;
    std::size_t triangles;
    double area;
  };
  const Row table[] = {
      {"a quad", square + "f 1 2 3 4\n", 2, 1},
      {"counted from the end", square + "f -4 -3 -2 -1", 2, 1},
      {"with texture coordinates and normals", square + "vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n", 1, 0.5},
      {"with normals alone", square + "vn 0 0 1\nf 1//1 2//1 3//1\n", 1, 0.5},
      {"with texture coordinates alone", square + "vt 0.5\nf 1/1 2/1 3/1\n", 1, 0.5},
      {"no line end, Windows line ends, tabs", "v 0 0 0\r\nv\t1 0 0\r\nv  1  1  0\r\nf 1\t2 3", 1, 0.5},
      {"old Macintosh line ends", "v 0 0 0\rv 1 0 0\rv 1 1 0\rf 1 2 3\r", 1, 0.5},
      {"a line continued", square + "f 1 2 \\\n 3 4\n", 2, 1},
      {"comments and a mark of UTF-8", "\xef\xbb\xbf# head\n" + square + "f 1 2 3 # tail\n", 1, 0.5},
      {"numbers of all kinds", "v +0. .0 -0\nv 1e0 0 0e5\nv 10e-1 +1.0E+0 0\nf 1 2 3\n", 1, 0.5},
      {"numbers below a float's range, and a double's", "v 1e-60 0 -1e-400\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", 1, 0.5},
      {"colours after positions", "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 0 1 0\nf 1 2 3\n", 1, 0.5},
      {"faces before what they name", "f 1/1/1 2/2/1 3/1/1\nvt 0 0\nvn 0 0 1\nvt 1 1\n" + square, 1, 0.5},
      {"points, lines and curves between", square + "p 1\nl 1 2\ncurv 0 1 1 2\nf 1 2\nf 1 2 3\n", 1, 0.5},
  };
  for (const Row& row : table) {
    INFO(row.name);
    const Scene scene = import_text(row.text);
    REQUIRE(scene.meshes.size() == 1);
    CHECK(scene.meshes[0].indices.size() == 3 * row.triangles);
    CHECK(area(scene.meshes[0]) == Approx(row.area));
    for (const Vertex& v : scene.meshes[0].vertices) CHECK(v.normal == glm::vec3(0, 0, 1));
  }
}

TEST_CASE("concave and irregular polygons are filled exactly", "[scene_import]") {
  struct Row {
    const char* name;
    std::vector<glm::vec3> corners;
    double area;  // -1: an outline that has none; only the count is asked for
  };
  std::vector<glm::vec3> comb;  // 200 teeth
  for (int i = 0; i < 200; ++i) comb.insert(comb.end(), {{i, 0, 0}, {i + 0.5, -1, 0}});
  comb.insert(comb.end(), {{200, 0, 0}, {200, 1, 0}, {0, 1, 0}});
  const Row table[] = {
      {"arrow head", {{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}}, 1},
      {"arrow head, clockwise", {{0, 0, 0}, {1, 1, 0}, {0, 2, 0}, {2, 1, 0}}, 1},
      {"the letter L, upright", {{0, 0, 0}, {0, 0, -3}, {0, 1, -3}, {0, 1, -1}, {0, 3, -1}, {0, 3, 0}}, 5},
      {"corners on a line", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, 4},
      {"a corner twice", {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 1},
      {"comb", comb, 300},
      {"star that crosses itself", {{0, 3, 0}, {2, -3, 0}, {-3, 1, 0}, {3, 1, 0}, {-2, -3, 0}}, -1},
      {"all at one place", {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, -1},
      {"a line", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, -1},
  };
  for (const Row& row : table) {
    INFO(row.name);
    const auto triangles = scene_import::triangulate(row.corners);
    CHECK(triangles.size() == row.corners.size() - 2);
    const glm::dvec3 whole = scene_import::newell_normal(row.corners);
    double sum = 0;
    for (const auto& [a, b, c] : triangles) {
      const glm::dvec3 p(row.corners[a]), q(row.corners[b]), r(row.corners[c]);
      const glm::dvec3 cross = glm::cross(q - p, r - p);
      sum += glm::length(cross) / 2;
      if (row.area > 0) CHECK(glm::dot(cross, whole) >= 0);  // wound as the polygon is
    }
    if (row.area > 0) CHECK(sum == Approx(row.area));
  }
}

TEST_CASE("missing normals follow smoothing groups, or else the angles between faces", "[scene_import]") {
  // A roof: two slopes that meet at a ridge along z, 90 degrees apart; and a flat one, 20 degrees apart.
  const auto roof = [](double slope, const std::string& smoothing) {
    const double h = std::tan(slope * 3.14159265358979 / 180);
    return "v -1 0 0\nv 0 " + std::to_string(h) + " 0\nv 1 0 0\nv -1 0 -1\nv 0 " + std::to_string(h) +
           " -1\nv 1 0 -1\n" + smoothing + "f 1 2 5 4\nf 2 3 6 5\n";
  };
  const auto ridge = [](const Scene& scene) {  // do both slopes share their normals on the ridge?
    for (const Vertex& v : scene.meshes.at(0).vertices)
      if (v.position.x == 0 && std::abs(v.normal.x) > 1e-6f) return false;
    return true;
  };
  struct Row {
    const char* name;
    double slope;
    const char* smoothing;
    bool smooth;
  };
  const Row table[] = {
      {"gentle, not said", 10, "", true},      {"steep, not said", 45, "", false},
      {"gentle, off", 10, "s off\n", false},   {"gentle, zero", 10, "s 0\n", false},
      {"steep, one group", 45, "s 1\n", true},
  };
  for (const Row& row : table) {
    INFO(row.name);
    CHECK(ridge(import_text(roof(row.slope, row.smoothing))) == row.smooth);
  }
}

TEST_CASE("materials and groups of OBJ", "[scene_import]") {
  std::vector<std::string> notes;
  const std::string obj = "mtllib model.mtl\n" + square +
                          "o front\nusemtl red paint\nf 1 2 3\nusemtl dull\nf 1 3 4\n"
                          "o back\nusemtl unknown\nf 3 2 1\n";
  const std::string mtl =
      "Kd 9 9 9\n"  // before the first newmtl: nobody's
      "newmtl red paint\nKd 0.8 0.1 0.1\nKs 0.5\nNs 40\nKe 0 0 1\nillum 2\nmap_Kd -s 2 2 -clamp on missing one.png\n"
      "newmtl dull\nKd 0.5 0.5 0.5\nKs 1 1 1\nNs 90\nillum 1\n";
  const Scene scene = import_text(obj, mtl, &notes);
  REQUIRE(scene.nodes.size() == 3);
  CHECK(scene.nodes[0].name == "front");
  CHECK(scene.nodes[2].name == "back");
  const auto material = [&](int node) { return scene.materials.at(scene.nodes[node].material); };
  CHECK(material(0).name == "red paint");
  CHECK(material(0).diffuse == glm::vec3(0.8f, 0.1f, 0.1f));
  CHECK(material(0).specular == glm::vec3(0.5f));
  CHECK(material(0).exponent == 40);
  CHECK(material(0).emission == glm::vec3(0, 0, 1));
  CHECK(material(1).specular == glm::vec3(0));  // illum 1 has no highlight
  CHECK(material(2).diffuse == glm::vec3(0.8f));
  REQUIRE(notes.size() == 2);
  CHECK(mentions(notes[0], {"missing one.png"}));
  CHECK(mentions(notes[1], {"'unknown'"}));
}

TEST_CASE("a grey bump picture holds heights, a coloured one normals", "[scene_import]") {
  const TemporaryFolder folder;
  const WriteOptions data{.encoding = Encoding::data};
  write_image(folder.path() / "grey.png", Image(4, 4, {0.5f, 0.5f, 0.5f, 1}), data);
  write_image(folder.path() / "blue.png", Image(4, 4, {0.5f, 0.5f, 1, 1}), data);
  write_file(folder.path() / "model.mtl", "newmtl a\nmap_Bump -bm 1 grey.png\nnewmtl b\nbump .\\blue.png\n");
  write_file(folder.path() / "model.obj", "mtllib ./model.mtl\n" + square + "usemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\n");
  const Scene scene = import_scene(folder.path() / "model.obj");
  CHECK(scene.materials.at(0).height_texture);
  CHECK_FALSE(scene.materials.at(0).normal_texture);
  CHECK(scene.materials.at(1).normal_texture);
  CHECK_FALSE(scene.materials.at(1).height_texture);

  write_file(folder.path() / "grey.png", "no picture at all");
  CHECK(mentions(error_of([&] { import_scene(folder.path() / "model.obj"); }), {"grey.png"}));
}

TEST_CASE("broken OBJ is refused with the line", "[scene_import]") {
  struct Row {
    const char* name;
    std::string text;
    std::vector<std::string> words;
  };
  const Row table[] = {
      {"empty", "", {"empty"}},
      {"nothing but comments", "# nothing\n", {"no triangles to draw"}},
      {"vertex out of range", square + "f 1 2 9\n", {":5: vertex 9 of 4"}},
      {"vertices that never come", "f 1 2 3\nf 1 2 9\nf 1 2 3\nf 1 2 12\n" + square, {":2: vertex 9 of 4"}},
      {"a vertex beyond all numbers", square + "f 1 2 3000000000\n", {":5: vertex 3000000000 of 4"}},
      {"vertex zero", square + "f 0 1 2\n", {":5: vertex 0 of 4"}},
      {"vertex before the first", square + "f -5 1 2\n", {"vertex -5 of 4"}},
      {"vertex beyond integers", square + "f 99999999999999999999 1 2\n", {"'99999999999999999999'"}},
      {"vertex of letters", square + "f a b c\n", {"'a' is not a vertex number"}},
      {"two coordinates", "v 1 2\n", {":1: a vertex needs three"}},
      {"coordinate of letters", "v 1 2 three\n", {":1: 'three' is not a number"}},
      {"coordinate with a tail", "v 1 2 3x\n", {"'3x'"}},
      {"not a number", "v 0 nan 0\n", {"not finite"}},
      {"not a number, as Microsoft's library writes it", "v 0 -1.#IND 0\n", {"not finite"}},
      {"endless", "v 0 0 -inf\n", {"not finite"}},
      {"beyond floats", "v 0 1e39 0\n", {"not finite"}},
      {"beyond doubles", "v 0 1e999 0\n", {"not finite"}},
      {"UTF-16", std::string("\xff\xfev\0 \0", 6), {"UTF-16"}},
      {"bytes of zero", std::string("v 0\0 0 0\n", 9), {"not a text file"}},
  };
  for (const Row& row : table) {
    INFO(row.name);
    const std::string message = error_of([&] { import_text(row.text); });
    INFO(message);
    CHECK(mentions(message, {"model.obj"}));
    for (const std::string& word : row.words) CHECK(mentions(message, {word}));
  }
  std::string wide = square + "f";
  for (int i = 0; i < 10'001; ++i) wide += " 1";
  CHECK(mentions(error_of([&] { import_text(wide); }), {":5:", "10000 corners"}));
}

TEST_CASE("what a corner may lack is no reason to refuse a model", "[scene_import]") {
  const struct {
    const char* name;
    std::string text;
    const char* note;
  } rows[] = {
      {"normals that there are not", square + "f 1//1 2//1 3//1\n", "3 numbers of texture coordinates or normals"},
      {"texture coordinates that there are not", square + "f 1/2 2/2 3/2\n", "3 numbers"},
      {"texture coordinate 0", square + "vt 0 0\nf 1/0 2/1 3/1\n", "1 numbers"},
      {"normals that are none", square + "vn -1.#IND00 -1.#IND00 -1.#IND00\nf 1//1 2//1 3//1\n", "had no direction"},
      {"what comes later", "f 1/1/1 2/1/1 3/1/1\nvt 0 0\nvn 0 0 1\n" + square, ""},
      {"empty places", square + "f 1// 2// 3//\n", ""},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    std::vector<std::string> notes;
    const Scene scene = import_text(row.text, "", &notes);
    REQUIRE(scene.meshes.size() == 1);
    for (const Vertex& vertex : scene.meshes[0].vertices) CHECK(vertex.normal == glm::vec3(0, 0, 1));
    CHECK(notes.size() == (*row.note ? 1u : 0u));
    if (*row.note) CHECK(mentions(notes.at(0), {row.note}));
  }
}

namespace {

/// Two squares, each with a material of its own.
std::string two_squares(const std::string& libraries, const std::string& first, const std::string& second) {
  return "mtllib " + libraries + "\n" + square + "v 2 0 0\nv 3 0 0\nv 3 1 0\nvt 0 0\nusemtl " + first +
         "\nf 1/1 2/1 3/1\nusemtl " + second + "\nf 5/1 6/1 7/1\n";
}

std::vector<glm::vec3> colours(const Scene& scene) {
  std::vector<glm::vec3> found;
  for (const Node& node : scene.nodes)
    if (node.mesh) found.push_back(scene.materials[std::size_t(node.material)].diffuse);
  return found;
}

}  // namespace

TEST_CASE("names of materials, libraries and pictures are what their lines say", "[scene_import]") {
  const glm::vec3 red(0.8f, 0, 0), green(0, 0.8f, 0);
  const std::vector both = {red, green};
  std::vector<std::string> notes;
  CHECK(colours(import_text(two_squares("model.mtl", "Material #1", "Material #2"),
                            "newmtl Material #1\nKd 0.8 0 0 # red\nnewmtl Material #2\n#Kd 1 1 1\nKd 0 0.8 0\n",
                            &notes)) == both);
  CHECK(notes.empty());
  CHECK(colours(import_text(two_squares("model.mtl", "a # first", "b #second"),
                            "newmtl a\nKd 0.8 0 0\nnewmtl b\nKd 0 0.8 0\n", &notes)) == both);
  CHECK(notes.empty());

  const TemporaryFolder folder;
  const auto import = [&](const std::string& text) {
    write_file(folder.path() / "model.obj", text);
    notes.clear();
    return import_scene(folder.path() / "model.obj", &notes);
  };
  std::filesystem::create_directory(folder.path() / "mats");
  write_file(folder.path() / "a.mtl", "newmtl a\nKd 0.8 0 0\n");
  write_file(folder.path() / "b.mtl", "newmtl b\nKd 0 0.8 0\n");
  write_file(folder.path() / "a b.mtl", "newmtl a\nKd 0 0.8 0\nnewmtl b\nKd 0.8 0 0\n");
  CHECK(colours(import(two_squares("a.mtl b.mtl", "a", "b"))) == both);
  CHECK(notes.empty());
  CHECK(colours(import(two_squares("a b.mtl", "b", "a"))) == both);  // the whole line comes first
  CHECK(colours(import(two_squares("a.mtl none.mtl", "a", "b"))).at(0) == red);
  CHECK(mentions(notes.at(0), {"none.mtl"}));

  write_image(folder.path() / "tex#1.png", Image(2, 2));
  write_image(folder.path() / "mats" / "inner.png", Image(3, 3));
  write_file(folder.path() / "mats" / "m.mtl",
             "newmtl a\nmap_Kd tex#1.png\nnewmtl b\nmap_Kd -s 2 2 1 inner.png\nd 0.2\n");
  const Scene pictures = import(two_squares("mats/m.mtl", "a", "b"));
  REQUIRE(pictures.textures.size() == 2);
  CHECK(pictures.textures[0].pixels.width() == 2);  // beside the model
  CHECK(pictures.textures[1].pixels.width() == 3);  // beside the library
  CHECK(import(two_squares("mats\\m.mtl", "a", "b")).textures.at(1).pixels.width() == 3);
  REQUIRE(notes.size() == 2);
  CHECK(mentions(notes[0] + notes[1], {"'b' is transparent", "'inner.png' is scaled or moved"}));
}

TEST_CASE("a material is no reason to refuse a model", "[scene_import]") {
  for (const char* line : {"Kd xyz 0.4 0.3 0.2", "Kd 0,8 0,1 0,1", "illum illum_2", "Ns x"}) {
    INFO(line);
    std::vector<std::string> notes;
    const Scene scene = import_text("mtllib model.mtl\nusemtl a\n" + square + "f 1 2 3\n",
                                    std::string("newmtl a\nKd 0.2 0.3 0.4\n") + line + "\nKs 0.1 0.1 0.1\n", &notes);
    CHECK(scene.materials.at(0).diffuse == glm::vec3(0.2f, 0.3f, 0.4f));
    CHECK(scene.materials.at(0).specular == glm::vec3(0.1f));
    REQUIRE(notes.size() == 1);
    CHECK(mentions(notes[0], {"model.mtl:3: ", "left out"}));
  }
}

TEST_CASE("material libraries outside the folder are not read", "[scene_import]") {
  for (const char* name : {"../model.mtl", "/etc/passwd", "C:\\materials\\a.mtl"}) {
    std::vector<std::string> notes;
    import_text("mtllib " + std::string(name) + "\n" + square + "f 1 2 3\n", "", &notes);
    REQUIRE(notes.size() == 1);
    CHECK(mentions(notes[0], {"left out", "folder"}));
  }
}

TEST_CASE("OBJ with flipped bytes gives a scene or an Error", "[scene_import]") {
  const std::string sound =
      "mtllib model.mtl\n" + square + "vt 0 0\nvn 0 0 1\no a\ns 1\nusemtl m\nf 1/1/1 2/1/1 3/1/1 4/1/1\n";
  std::uint32_t random = 99;
  for (int round = 0; round < 400; ++round) {
    std::string broken = sound;
    for (int flips = 0; flips < 1 + round % 3; ++flips) {
      random = random * 1664525u + 1013904223u;  // a linear congruential generator (Numerical Recipes)
      broken[(random >> 8) % broken.size()] = char(random >> 24);
    }
    error_of([&] { import_text(broken, "newmtl m\nKd 1 0 0\n"); });
  }
  SUCCEED("no crash");
}
