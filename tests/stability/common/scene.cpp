// scene/ and scene_import/: exact world matrices, bounds, and normals that files bring or lack.
#include <climits>

#include "scene/scene.hpp"
#include "scene_import/frame.hpp"
#include "scene_import/normals.hpp"
#include "stability/common/rows.hpp"

namespace atelier::stability {

namespace {

std::vector<Node> chain(int depth) {
  std::vector<Node> nodes(std::size_t(depth), Node{});
  for (int i = 0; i < depth; ++i) {
    nodes[std::size_t(i)].parent = i + 1 < depth ? i + 1 : -1;
    nodes[std::size_t(i)].translation = {1, 0, 0};
  }
  return nodes;
}

Values origin_of(const glm::dmat4& m) {
  return values(glm::dvec3(m[3]));
}

void add_hierarchy_rows(Table& table) {
  Group group = table.of("world_matrices_exact");
  group.equals("a chain 100 000 deep", [] { return origin_of(world_matrices_exact(chain(100'000)).front()); },
               {1e5, 0, 0});
  group.equals("1e6 m from the origin, a micrometre step",
               [] {
                 std::vector<Node> nodes(2);
                 nodes[0].translation = glm::dvec3(1e6);
                 nodes[1].parent = 0;
                 nodes[1].translation = {0x1p-20, 0, 0};
                 return origin_of(world_matrices_exact(nodes)[1]);
               },
               {1e6 + 0x1p-20, 1e6, 1e6});
  for (const int parent : {INT_MIN, -2, 3, INT_MAX})
    group.refuses(fmt::format("a parent of {}", parent), [=] {
      std::vector<Node> nodes(3);
      nodes[1].parent = parent;
      world_matrices_exact(nodes);
    });
  for (const int length : {1, 2, 10'000})
    group.refuses(fmt::format("a cycle of {}", length), [=] {
      std::vector<Node> nodes(std::size_t(length), Node{});
      for (int i = 0; i < length; ++i) nodes[std::size_t(i)].parent = (i + 1) % length;
      world_matrices_exact(nodes);
    });
  group.close("an axis of any length, 1e-30 to 1e30",
              {1e-7, "absolute", "the axis is made of floats, each a rounding of what is expected"}, [] {
                double worst = 0;
                for (const float size : {1e-30f, 1e-10f, 1.0f, 1e10f, 1e30f}) {
                  std::vector<Node> nodes(1);
                  nodes[0].rotation_axis = size * glm::vec3(0, 0, 1);
                  nodes[0].rotation_angle = 1;
                  const glm::dmat4 m = world_matrices_exact(nodes)[0];
                  worst = std::max(worst, difference(values(glm::dvec3(m[0])), {std::cos(1.0), std::sin(1.0), 0}));
                }
                return worst;
              });
}

void add_normal_rows(Table& table) {
  using scene_import::Facet;
  using scene_import::facet_normals;
  Group group = table.of("facet_normals");
  const auto first_normal = [](const std::vector<glm::vec3>& positions) {
    return values(facet_normals(positions, {Facet{{0, 1, 2}, 1}})[0][0]);
  };
  group.equals("a triangle without area: +y",
               [=] {
                 return first_normal({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
               },
               {0, 1, 0});
  group.equals("three corners in one place: +y",
               [=] {
                 return first_normal({{3, 3, 3}, {3, 3, 3}, {3, 3, 3}});
               },
               {0, 1, 0});
  for (const float size : {1e-15f, 1e-6f, 1e6f, 1e15f})
    group.close(fmt::format("a triangle {:g} m wide", size),
                {4 * rounding_unit, "absolute", "a cross product, normalised"}, [=] {
                  return difference(first_normal({{0, 0, 0}, {size, 0, 0}, {0, size, 0}}), {0, 0, 1});
                });

  Group fix = table.of("fix_normals");
  fix.equals("zero, NaN and infinite normals are replaced",
             [] {
               Mesh mesh;
               for (const glm::vec3& n : {glm::vec3(0), glm::vec3(not_a_number), glm::vec3(infinite)})
                 mesh.vertices.push_back({{}, n, {}});
               mesh.vertices[1].position = {1, 0, 0}, mesh.vertices[2].position = {0, 1, 0};
               mesh.indices = {0, 1, 2};
               Values out = {double(scene_import::fix_normals(mesh))};
               for (const Vertex& v : mesh.vertices) {
                 const Values n = values(v.normal);
                 out.insert(out.end(), n.begin(), n.end());
               }
               return out;
             },
             {3, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  fix.close("normals 1e-5 and 1e15 long become unit vectors", {4 * rounding_unit, "absolute", "a normalisation"}, [] {
    Mesh mesh;
    for (const float size : {1e-5f, 1.0f, 1e15f}) mesh.vertices.push_back({{size, 1, 0}, glm::vec3(0, 0, size), {}});
    mesh.indices = {0, 1, 2};
    scene_import::fix_normals(mesh);
    double worst = 0;
    for (const Vertex& v : mesh.vertices) worst = std::max(worst, difference(values(v.normal), {0, 0, 1}));
    return worst;
  });
}

void add_frame_rows(Table& table) {
  Group group = table.of("camera_around");
  for (const double size : {1e-6, 1.0, 1e6})
    for (const double offset : {0.0, 1e6})
      group.finite(fmt::format("a model {:g} m wide, {:g} m from the origin", size, offset), [=] {
        Box3 box;
        box.add(glm::dvec3(offset));
        box.add(glm::dvec3(offset + size));
        const Camera camera = scene_import::camera_around(box);
        Values out = values(camera.eye);
        out.insert(out.end(),
                   {double(camera.near), double(camera.far), 1 / double(camera.far > camera.near && camera.near > 0)});
        return out;
      });
  group.finite("a model of a single point", [] {
    Box3 box;
    box.add({1, 2, 3});
    const Camera camera = scene_import::camera_around(box);
    return Values{camera.eye.x, 1 / double(camera.eye != camera.target),
                  1 / double(camera.near > 0 && camera.far > camera.near)};
  });
}

}  // namespace

void add_scene_rows(Table& table) {
  add_hierarchy_rows(table);
  add_normal_rows(table);
  add_frame_rows(table);
}

}  // namespace atelier::stability
