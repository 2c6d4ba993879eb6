// scene/shapes: the smallest and largest measures, the fewest and most pieces.
#include "scene/shapes.hpp"
#include "stability/common/rows.hpp"

namespace atelier::stability {

namespace {

/// How many of a mesh's promises are broken: unit normals, finite numbers, indices in range, triangles with an area
/// that face the way their normals do. Areas are taken of positions divided by `size`.
double broken_promises(const Mesh& mesh, double size) {
  double broken = mesh.indices.size() % 3 + (mesh.vertices.empty() ? 1.0 : 0.0);
  for (const Vertex& v : mesh.vertices) {
    broken += std::abs(glm::length(glm::dvec3(v.normal)) - 1) > 1e-6;
    broken += double(count_non_finite(values(v.position)) + count_non_finite(values(v.texcoord)));
  }
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::uint32_t corner[3] = {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
    if (std::max({corner[0], corner[1], corner[2]}) >= mesh.vertices.size()) return infinite;
    const auto at = [&](int k) { return glm::dvec3(mesh.vertices[corner[k]].position) / size; };
    const glm::dvec3 area = glm::cross(at(1) - at(0), at(2) - at(0));
    const auto normal = [&](int k) { return glm::dvec3(mesh.vertices[corner[k]].normal); };
    broken += !(glm::dot(area, normal(0) + normal(1) + normal(2)) > 0);
  }
  return broken;
}

/// Every shape at a size, with the fewest pieces where `few`.
struct Shape {
  const char* name;
  std::function<Mesh(float size, bool few)> make;
};

const Shape shapes[] = {
    {"make_sphere",
     [](float s, bool few) {
       return make_sphere({s, few ? 3 : 48, few ? 2 : 24});
     }},
    {"make_icosphere",
     [](float s, bool few) {
       return make_icosphere({s, few ? 0 : 3});
     }},
    {"make_torus",
     [](float s, bool few) {
       return make_torus({s, s / 3, few ? 3 : 48, few ? 3 : 24});
     }},
    {"make_box", [](float s, bool) { return make_box({glm::vec3(s, s / 2, s / 3)}); }},
    {"make_plane",
     [](float s, bool few) {
       return make_plane({s, s / 2, glm::vec2(1), few ? 1 : 40, few ? 1 : 30});
     }},
    {"make_cylinder_wall",
     [](float s, bool few) {
       return make_cylinder_wall({s, s / 2, few ? 3 : 64});
     }},
    {"make_disc",
     [](float s, bool few) {
       return make_disc({s, few ? 3 : 64});
     }},
    {"make_cylinder",
     [](float s, bool few) {
       return make_cylinder({s, s / 2, few ? 3 : 64});
     }},
    {"make_cone",
     [](float s, bool few) {
       return make_cone({s, s / 2, few ? 3 : 64});
     }},
    {"make_teapot",
     [](float s, bool few) {
       return make_teapot({s, few ? 3 : 8});
     }},
};

void add_refusals(Table& table) {
  for (const Shape& shape : shapes) {
    Group group = table.of(shape.name);
    const std::pair<const char*, float> sizes[] = {{"zero", 0.0f},         {"negative", -1.0f}, {"NaN", not_a_number},
                                                   {"infinite", infinite}, {"1e-30 m", 1e-30f}, {"1e30 m", 1e30f}};
    for (const auto& [words, size] : sizes)
      group.refuses(fmt::format("a size that is {}", words), [make = shape.make, size = size] { make(size, false); });
  }
  table.of("make_sphere").refuses("2 segments", [] { make_sphere({1, 2, 24}); });
  table.of("make_sphere").refuses("1 ring", [] { make_sphere({1, 48, 1}); });
  table.of("make_icosphere").refuses("9 subdivisions", [] { make_icosphere({1, 9}); });
  table.of("make_torus").refuses("a tube as thick as the ring", [] { make_torus({1, 1, 8, 8}); });
  table.of("make_cylinder_wall").refuses("65 537 segments", [] { make_cylinder_wall({1, 1, 65'537}); });
  table.of("make_teapot").refuses("1 subdivision", [] { make_teapot({1, 1}); });
}

}  // namespace

void add_shape_rows(Table& table) {
  for (const Shape& shape : shapes) {
    Group group = table.of(shape.name);
    for (const float size : {4e-6f, 1.0f, 9e5f})
      for (const bool few : {true, false})
        group.equals(fmt::format("{:g} m, {} pieces: whole, finite, facing out", size, few ? "the fewest" : "many"),
                     [make = shape.make, size, few] { return Values{broken_promises(make(size, few), double(size))}; },
                     {0});
  }
  table.of("make_cylinder_wall")
      .close("65 536 segments: on the circle", {4 * rounding_unit, "of the radius", "cosine, sine and a product"}, [] {
        double worst = 0;
        for (const Vertex& v : make_cylinder_wall({1, 1, 65'536}).vertices)
          worst = std::max(worst, std::abs(std::hypot(double(v.position.x), double(v.position.z)) - 1));
        return worst;
      });
  add_refusals(table);
}

}  // namespace atelier::stability
