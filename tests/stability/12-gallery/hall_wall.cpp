// hall_wall: the fewest sides and thousands, from a micrometre to a thousand kilometres, and textures that run around
// very often. Whatever the triangles are, their corners, their area and their sides are known.
#include "stability/12-gallery/rows.hpp"

namespace atelier::stability {

using namespace gallery;

namespace {

struct Wall {
  int segments;
  float radius, height, repeat;

  Mesh mesh() const { return hall_wall(segments, radius, height, repeat); }
  double half_angle() const { return std::numbers::pi / segments; }  ///< of a side, seen from the axis
};

/// The angle of a place about the axis, 0 at +z and rising in the order of u, 0 to 2 pi.
double angle_of(const glm::vec3& place) {
  const double angle = std::atan2(-double(place.x), double(place.z));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

/// The error of each vertex, the largest of all.
template <class Error>
double worst_vertex(const Wall& wall, Error error) {
  const Mesh mesh = wall.mesh();
  double worst = mesh.vertices.empty() ? double(infinite) : 0;
  for (const Vertex& vertex : mesh.vertices) {
    const double here = error(vertex);
    worst = std::isnan(here) ? double(infinite) : std::max(worst, here);
  }
  return worst;
}

/// How far a place is from the sides, as a share of the radius.
double off_sides(const Wall& wall, const Vertex& vertex) {
  const double angle = angle_of(vertex.position), step = 2 * wall.half_angle();
  // Next to a corner two sides may be meant.
  double least = infinite;
  for (const double side : {std::floor(angle / step - 0.25), std::floor(angle / step + 0.25)}) {
    const double middle = (side + 0.5) * step;
    const double along = -std::sin(middle) * double(vertex.position.x) + std::cos(middle) * double(vertex.position.z);
    least = std::min(least, std::abs(along / double(wall.radius) - std::cos(wall.half_angle())));
  }
  return least;
}

/// How far the corner that is missed most is from the nearest vertex, as a share of the radius, below and above. A
/// vertex is looked for at the corner next to its angle.
double farthest_corner(const Wall& wall) {
  const auto count = std::size_t(wall.segments);
  std::vector<double> nearest(2 * count, double(infinite));
  for (const Vertex& vertex : wall.mesh().vertices) {
    const auto corner = std::size_t(std::lround(angle_of(vertex.position) / (2 * wall.half_angle()))) % count;
    const double angle = 2 * wall.half_angle() * double(corner);
    const bool above = vertex.position.y > wall.height / 2;
    if (vertex.position.y != (above ? wall.height : 0)) continue;
    const glm::dvec2 place(glm::dvec2(vertex.position.x, vertex.position.z) / double(wall.radius));
    double& best = nearest[2 * corner + (above ? 1 : 0)];
    best = std::min(best, glm::length(place - glm::dvec2(-std::sin(angle), std::cos(angle))));
  }
  return *std::ranges::max_element(nearest);
}

double normal_error(const Vertex& vertex) {
  const double angle = angle_of(vertex.position);
  return difference(values(vertex.normal), {std::sin(angle), 0, -std::cos(angle)});
}

/// How far a vertex's u is from its share of the turn, as a share of `repeat`; at +z it may be 0 or `repeat`. In a side
/// u is even along it, which only corners tell apart from the angle.
double u_error(const Wall& wall, const Vertex& vertex) {
  const double turns = angle_of(vertex.position) / (2 * std::numbers::pi), corner = turns * wall.segments;
  if (std::abs(corner - std::round(corner)) > 0.01) return 0;
  const double u = double(vertex.texcoord.x) / double(wall.repeat), off = std::abs(u - turns);
  return turns < 0.01 / wall.segments || turns > 1 - 0.01 / wall.segments ? std::min(std::abs(u), std::abs(u - 1))
                                                                          : off;
}

/// How much more of the texture a triangle has than one side does, as a share of a side, at the worst.
double widest_triangle(const Wall& wall) {
  const Mesh mesh = wall.mesh();
  double worst = 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const auto u = [&](std::size_t k) { return double(mesh.vertices.at(mesh.indices[i + k]).texcoord.x); };
    const auto [low, high] = std::minmax({u(0), u(1), u(2)});
    worst = std::max(worst, (high - low) / double(wall.repeat) * wall.segments - 1);
  }
  return worst;
}

/// The places of all vertices at the seam whose u is this many times `repeat` (0 or 1), in order, each once. Two of no
/// places are not equal.
Values places_at(const Wall& wall, double share) {
  const Mesh mesh = wall.mesh();
  std::vector<Values> places;
  for (const Vertex& vertex : mesh.vertices)
    if (std::abs(double(vertex.texcoord.x) / double(wall.repeat) - share) <= 4 * rounding_unit)
      places.push_back({double(vertex.position.y), double(vertex.position.x), double(vertex.position.z)});
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  Values all;
  if (places.empty()) all.push_back(double(not_a_number));
  for (const Values& place : places) all.insert(all.end(), place.begin(), place.end());
  return all;
}

glm::dvec3 area_vector(const Mesh& mesh, std::size_t triangle) {
  const auto at = [&](std::size_t k) { return glm::dvec3(mesh.vertices.at(mesh.indices[3 * triangle + k]).position); };
  return glm::cross(at(1) - at(0), at(2) - at(0)) / 2.0;
}

double area_error(const Wall& wall) {
  const Mesh mesh = wall.mesh();
  double area = 0;
  for (std::size_t i = 0; i < mesh.indices.size() / 3; ++i) area += glm::length(area_vector(mesh, i));
  const double side = 2 * double(wall.radius) * std::sin(wall.half_angle());
  return std::abs(area / (wall.segments * side * double(wall.height)) - 1);
}

/// How many triangles do not face the axis, or are incomplete.
double facing_away(const Wall& wall) {
  const Mesh mesh = wall.mesh();
  double wrong = double(mesh.indices.size() % 3) + double(mesh.indices.empty());
  for (std::size_t i = 0; i < mesh.indices.size() / 3; ++i) {
    const glm::dvec3 place(mesh.vertices.at(mesh.indices[3 * i]).position);
    wrong += !(glm::dot(area_vector(mesh, i), glm::dvec3(-place.x, 0, -place.z)) > 0);
  }
  return wrong;
}

void add_rows_of(Group& group, const Wall& wall) {
  const std::string words = fmt::format("{} sides, radius {:g} m, height {:g} m, {:g} repetitions", wall.segments,
                                        wall.radius, wall.height, wall.repeat);
  group.close(words + ": corners", {4 * rounding_unit, "of the radius", "a cosine, a sine and their products, rounded"},
              [=] { return farthest_corner(wall); });
  group.close(words + ": on the sides", {4 * rounding_unit, "of the radius", "roundings of the corners"},
              [=] { return worst_vertex(wall, [&](const Vertex& vertex) { return off_sides(wall, vertex); }); });
  group.close(words + ": normals", {4 * rounding_unit, "absolute", "the place and the normal are rounded"},
              [=] { return worst_vertex(wall, normal_error); });
  group.close(words + ": unit normals", {4 * rounding_unit, "absolute", "a cosine and a sine, rounded"}, [=] {
    return worst_vertex(wall,
                        [](const Vertex& vertex) { return std::abs(glm::length(glm::dvec3(vertex.normal)) - 1); });
  });
  group.close(words + ": u at the corners", {4 * rounding_unit, "of the repetitions", "a quotient and a product"},
              [=] { return worst_vertex(wall, [&](const Vertex& vertex) { return u_error(wall, vertex); }); });
  group.close(words + ": no triangle has more of the texture than a side",
              {4 * rounding_unit * wall.segments, "of a side", "u has roundings of all repetitions"},
              [=] { return widest_triangle(wall); });
  group.close(words + ": v", {4 * rounding_unit, "absolute", "a quotient of two heights"}, [=] {
    return worst_vertex(wall, [&](const Vertex& vertex) {
      return std::abs(double(vertex.texcoord.y) - double(vertex.position.y) / double(wall.height));
    });
  });
  // What a rounding across a side adds to it is of second order, and what it takes from one along it the next one gets.
  group.close(words + ": area", {8 * rounding_unit, "relative", "roundings of the radius and of the height"},
              [=] { return area_error(wall); });
  group.equals(words + ": triangles that face away", [=] { return Values{facing_away(wall)}; }, {0});
  group.same(
      words + ": the last corners are at the places of the first", [=] { return places_at(wall, 1); },
      [=] { return places_at(wall, 0); });
}

}  // namespace

void add_wall_rows(Table& table) {
  Group group = table.of("hall_wall");
  for (const int segments : {3, 4, 5, 64, 4096})
    for (const float radius : {1e-6f, 6.0f, 1e6f}) add_rows_of(group, {segments, radius, 3.6f, 10});
  for (const float height : {1e-6f, 1e6f}) add_rows_of(group, {7, 6, height, 1});
  for (const float repeat : {1e-6f, 1.0f / 3, 1e6f}) add_rows_of(group, {24, 6, 3.6f, repeat});
}

}  // namespace atelier::stability
