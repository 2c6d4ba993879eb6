// cylinder_wall and rectangle.
#include "stability/01-transforms/exact.hpp"
#include "stability/01-transforms/rows.hpp"

namespace atelier::stability {

using transforms::cylinder_wall;
using transforms::rectangle;

namespace {

/// The largest distance of a vertex from its place on the circle, as a share of the radius and the height.
double wall_error(float radius, float height, int segments) {
  const Mesh wall = cylinder_wall(radius, height, segments);
  if (wall.vertices.size() != 2 * (std::size_t(segments) + 1)) return infinite;
  double worst = 0;
  for (std::size_t i = 0; i < wall.vertices.size(); ++i) {
    const double phi = 2 * std::numbers::pi * double(i / 2) / segments;
    const glm::dvec3 p = wall.vertices[i].position;
    worst = std::max(
        worst, difference({p.x / radius, p.y / height, p.z / radius}, {std::cos(phi), double(i % 2), std::sin(phi)}));
  }
  return worst;
}

Values position_of(const Mesh& mesh, std::size_t vertex) {
  return values(mesh.vertices.at(vertex).position);
}

/// How many triangles turn their back to the axis, or have no area.
double turned_away(const Mesh& wall) {
  double count = 0;
  for (std::size_t i = 0; i + 2 < wall.indices.size(); i += 3) {
    glm::dvec3 corner[3];
    for (std::size_t k = 0; k < 3; ++k) corner[k] = wall.vertices.at(wall.indices[i + k]).position;
    const glm::dvec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
    const glm::dvec3 to_axis(-corner[0].x, 0, -corner[0].z);
    count += !(glm::dot(normal, to_axis) > 0);
  }
  return count;
}

void add_wall_rows(Table& table) {
  Group group = table.of("cylinder_wall");
  const Bound place{22 * rounding_unit, "of radius and height",
                    "the angle, up to 2 pi, is three roundings of itself off, its cosine and the product one each"};
  struct Refused {
    const char* words;
    float radius, height;
    int segments;
  };
  const Refused refused[] = {{"2 segments", 1, 1, 2},         {"no segments", 1, 1, 0},
                             {"-3 segments", 1, 1, -3},       {"a radius of 0", 0, 1, 3},
                             {"a negative radius", -1, 1, 3}, {"a radius of NaN", not_a_number, 1, 3},
                             {"a height of 0", 1, 0, 3},      {"a height of NaN", 1, not_a_number, 3},
                             {"a negative height", 1, -1, 3}};
  for (const Refused& r : refused) group.refuses(r.words, [=] { cylinder_wall(r.radius, r.height, r.segments); });
  for (const int segments : {3, 5, 1000, 100'000})
    group.close(fmt::format("{} segments", segments), place, [=] { return wall_error(1, 1, segments); });
  for (const float size : {1e-30f, 1e-6f, 1e6f, 1e30f})
    group.close(fmt::format("a radius of {:g} m, a height of {:g} m", size, 1 / size), place,
                [=] { return wall_error(size, 1 / size, 16); });
  for (const int segments : {3, 7, 48, 99'999}) {
    group.equals(fmt::format("{} segments: the last pair lies exactly on the first", segments),
                 [=] {
                   const Mesh wall = cylinder_wall(0.7f, 1.3f, segments);
                   Values last = position_of(wall, 2 * std::size_t(segments));
                   const Values above = position_of(wall, 2 * std::size_t(segments) + 1);
                   last.insert(last.end(), above.begin(), above.end());
                   return last;
                 },
                 {double(0.7f), 0, 0, double(0.7f), double(1.3f), 0});
    group.equals(fmt::format("{} segments: every triangle faces the axis", segments),
                 [=] { return Values{turned_away(cylinder_wall(1, 1, segments))}; }, {0});
  }
  group.equals("the texture ends at u = 1",
               [] {
                 const Mesh wall = cylinder_wall(1, 1, 10);
                 return Values{double(wall.vertices.front().texcoord.x), double(wall.vertices.back().texcoord.x)};
               },
               {0, 1});
  for (const int segments : {3, 64})
    group.close(fmt::format("{} segments: the sagitta is R (1 - cos(pi/n))", segments), place, [=] {
      const Mesh wall = cylinder_wall(1, 1, segments);
      const glm::dvec3 middle = 0.5 * (glm::dvec3(wall.vertices[0].position) + glm::dvec3(wall.vertices[2].position));
      const double half = std::sin(std::numbers::pi / segments / 2);  // 1 - cos x = 2 sin^2(x/2)
      return std::abs(1 - std::hypot(middle.x, middle.z) - 2 * half * half);
    });
}

/// Degrees between the rectangle's normal and the exact one; infinite where the normal is not of unit length.
double rectangle_normal_error(const glm::vec3& half_u, const glm::vec3& half_v) {
  const glm::dvec3 normal = rectangle({0, 0, 0}, half_u, half_v).vertices.at(0).normal;
  if (!(std::abs(glm::length(normal) - 1) < 4 * rounding_unit)) return infinite;
  return degrees_between(normal, glm::cross(glm::dvec3(half_u), glm::dvec3(half_v)));
}

void add_rectangle_rows(Table& table) {
  Group group = table.of("rectangle");
  const Bound angle{2e-5, "degrees", "a cross product and a normalisation: three roundings are 2e-7 rad, 1e-5 degrees"};
  for (const float size : {1e-30f, 1e-15f, 1e-9f, 1e9f, 1e15f, 1e18f})
    group.close(fmt::format("half sides of {:.0e} m: the normal", size), angle,
                [=] { return rectangle_normal_error(size * glm::vec3(1, 2, 0), size * glm::vec3(0, 0.5f, 3)); });
  group.close("a strip of 1e-6 by 1e6 m: the normal", angle, [] {
    return rectangle_normal_error({1e6f, 0, 1e6f}, {0, 1e-6f, 0});
  });
  group.equals(
      "a million metres away: corners to the rounding of floats",
      [] {
        return all_values(std::vector{rectangle({1e6f, 0, 0}, {0.5f, 0, 0}, {0, 1, 0}).vertices.at(2).position});
      },
      {1e6 + 0.5, 1, 0});
  group.finite("half sides that are parallel: corners and texture coordinates", [] {
    Values out;
    for (const Vertex& v : rectangle({1, 2, 3}, {1, 0, 0}, {2, 0, 0}).vertices) {
      const Values position = values(v.position), texcoord = values(v.texcoord);
      out.insert(out.end(), position.begin(), position.end());
      out.insert(out.end(), texcoord.begin(), texcoord.end());
    }
    return out;
  });
  group.nan("a half side of NaN", [] {
    return values(rectangle({}, {not_a_number, 0, 0}, {0, 1, 0}).vertices[0].position);
  });
}

}  // namespace

void add_mesh_rows(Table& table) {
  add_wall_rows(table);
  add_rectangle_rows(table);
}

}  // namespace atelier::stability
