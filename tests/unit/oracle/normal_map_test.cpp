// Normal maps of the oracle against what they stand for: a surface with a relief.
#include <cmath>

#include "catch.hpp"
#include "oracle/oracle.hpp"
#include "scene/builder.hpp"
#include "scene/relief.hpp"
#include "scene/shapes.hpp"

using namespace atelier;

namespace {

const DimpleShape dimples{.size = 512, .dimples = 2, .depth = 0.04f};

double degrees_between(const Rgba& a, const Rgba& b) {
  const glm::dvec3 x = glm::dvec3(a.r, a.g, a.b) * 2.0 - 1.0, y = glm::dvec3(b.r, b.g, b.b) * 2.0 - 1.0;
  return std::atan2(glm::length(glm::cross(x, y)), glm::dot(x, y)) * 180 / 3.14159265358979;
}

/// The largest angle between the normals of two pictures, except near their edges.
double most_degrees(const Image& a, const Image& b) {
  double most = 0;
  for (int y = 4; y < a.height() - 4; ++y)
    for (int x = 4; x < a.width() - 4; ++x) most = std::max(most, degrees_between(a.at(x, y), b.at(x, y)));
  return most;
}

Scene seen_from_above() {
  Scene scene;
  scene.camera = {
      .eye = {0, 5, 0}, .up = {0, 0, -1}, .projection = Projection::orthographic, .height = 2, .near = 1, .far = 10};
  return scene;
}

/// A plate of 2 x 2 m under the normal map of the dimples.
Scene mapped_plate(Node node = {}) {
  Scene scene = seen_from_above();
  Material clay{.name = "clay"};
  clay.normal_texture = add_texture(scene, "dimples", make_dimples(dimples).normal, Filter::linear);
  add_object(scene, make_plane({.width = 2, .depth = 2}), add_material(scene, clay), node);
  return scene;
}

Image normals(const Scene& scene) {
  return oracle::trace(
      oracle::World(scene),
      {.camera = scene.camera, .size = {96, 96}, .output = oracle::Output::normal, .shading = {.normal_maps = true}});
}

/// The same plate as triangles that follow the relief; pictures of their geometric normals.
Image normals_of_relief() {
  Scene scene = seen_from_above();
  Mesh mesh = make_plane({.width = 2, .depth = 2, .columns = 300, .rows = 300});
  for (Vertex& vertex : mesh.vertices)
    vertex.position.y = float(2 * dimples.depth * dimples_at(dimples, vertex.texcoord.x, vertex.texcoord.y).x);
  add_object(scene, mesh, add_material(scene, {.name = "clay"}));
  const oracle::World world(scene);
  return oracle::trace(world, {.camera = scene.camera,
                               .size = {96, 96},
                               .shading = {.surface = [](const auto&, const oracle::SurfacePoint& point, const auto&) {
                                 return point.flat_normal * 0.5 + 0.5;
                               }}});
}

}  // namespace

TEST_CASE("a normal map looks like the relief that it was made from", "[oracle]") {
  // A facet of the relief is 1/150 m wide, and the slope changes by at most 4 per metre: 0.8 degrees from its middle.
  CHECK(most_degrees(normals(mapped_plate()), normals_of_relief()) < 1);
  CHECK(most_degrees(normals(mapped_plate()), Image(96, 96, {0.5f, 1, 0.5f, 1})) > 16);
}

TEST_CASE("bumps remain bumps under every model matrix", "[oracle]") {
  const Image upright = normals(mapped_plate());
  SECTION("mirrored: the dimples are symmetric") {
    CHECK(most_degrees(normals(mapped_plate({.scale = {-1, 1, 1}})), upright) < 1e-3);
    CHECK(most_degrees(normals(mapped_plate({.scale = {1, 1, -1}})), upright) < 1e-3);
  }
  SECTION("turned by a quarter") {
    CHECK(most_degrees(normals(mapped_plate({.rotation_angle = degrees(90)})), upright) < 1e-3);
  }
  SECTION("very small, and enlarged by a parent") {
    Scene scene = mapped_plate({.parent = 0, .scale = glm::vec3(-1e-15f, 1e-15f, 1e-15f)});
    scene.nodes.insert(scene.nodes.begin(), Node{.name = "parent", .scale = glm::vec3(1e15f)});
    CHECK(most_degrees(normals(scene), upright) < 1e-3);
  }
  SECTION("seen from behind, bumps are dents: every slope is reversed") {
    Scene scene = mapped_plate({.rotation_axis = {0, 0, 1}, .rotation_angle = degrees(180)});
    scene.materials[0].two_sided = true;
    const Image behind = normals(scene);
    Image dents = upright;
    for (Rgba& p : dents.pixels()) p.r = 1 - p.r, p.b = 1 - p.b;
    CHECK(most_degrees(behind, dents) < 0.05);  // degrees(180) is a float
  }
}

TEST_CASE("a corner that only degenerate triangles use has no frame", "[oracle]") {
  Scene scene = mapped_plate();
  for (Vertex& vertex : scene.meshes[0].vertices) vertex.texcoord = {0.3f, 0.4f};
  CHECK(most_degrees(normals(scene), Image(96, 96, {0.5f, 1, 0.5f, 1})) == 0);
}

TEST_CASE("tangents of a file are used as they are", "[oracle]") {
  Scene scene = mapped_plate();
  scene.meshes[0].tangents.assign(scene.meshes[0].vertices.size(), glm::vec4(0, 0, -1, 1));  // turned by a quarter
  Image turned(96, 96);
  const Image upright = normals(mapped_plate());
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x) {
      const Rgba& p = upright.at(x, y);
      turned.at(x, y) = {p.b, p.g, 1 - p.r, 1};
    }
  CHECK(most_degrees(normals(scene), turned) < 1e-3);
}
