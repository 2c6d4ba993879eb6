#include "oracle/world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "oracle/height_field.hpp"
#include "oracle/tangents.hpp"

namespace atelier::oracle {

namespace {

/// The upper left 3x3 block divided by its largest entry: so that products of entries neither overflow nor underflow.
glm::dmat3 scaled_block(const glm::dmat4& model) {
  glm::dmat3 m(model);
  double largest = 0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(m[column][row]));
  return largest > 0 ? m * (1 / largest) : m;
}

/// Whether the model matrix mirrors. Relative volumes below 1e-13 are rounding errors of a flattened model, whose sign
/// is meaningless.
bool mirrors(const glm::dmat4& model) {
  const glm::dmat3 m = scaled_block(model);
  const double span = glm::length(m[0]) * glm::length(m[1]) * glm::length(m[2]);
  return glm::determinant(m) < -1e-13 * span;
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : glm::dvec3(0);
}

/// The normal in world space. A model that is flattened in two directions maps some normals to zero; then the normal is
/// not changed.
glm::dvec3 world_normal(const glm::dmat3& normal_matrix, const glm::dvec3& normal) {
  const glm::dvec3 turned = normal_matrix * normal;
  return turned != glm::dvec3(0) ? glm::normalize(turned) : normal;
}

/// A tangent is transformed like a difference of positions. A mirroring model exchanges the sides of the surface, and
/// so the side of the bitangent.
glm::dvec4 world_tangent(const glm::dmat4& model, bool mirrored, const glm::dvec4& tangent) {
  return {unit_or_zero(glm::dmat3(model) * glm::dvec3(tangent)), mirrored ? -tangent.w : tangent.w};
}

/// The rectangle of a flat shape or a height field, whose sides are the axes of tangent space; none for others.
const Rectangle* base_of(const Surface& surface) {
  const auto* field = std::get_if<HeightField>(&surface);
  return field ? &field->flat : std::get_if<Rectangle>(&surface);
}

}  // namespace

glm::dmat3 normal_matrix_exact(const glm::dmat4& model) {
  const glm::dmat3 m = scaled_block(model);
  const glm::dmat3 cofactor(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  return mirrors(model) ? -cofactor : cofactor;
}

World::World(const Scene& scene, std::vector<Shape> shapes) : scene_(scene) {
  validate(scene);
  place_nodes();
  place_shapes(std::move(shapes));
  build_tree();
  images_ = light_images(scene);
}

void World::place_nodes() {
  const std::vector<glm::dmat4> matrices = world_matrices_exact(scene_.nodes);
  for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
    if (!scene_.nodes[i].mesh) continue;
    const Mesh& mesh = scene_.meshes[std::size_t(*scene_.nodes[i].mesh)];
    const glm::dmat3 normal_matrix = normal_matrix_exact(matrices[i]);
    const auto base = std::uint32_t(corners_.size());
    const bool mirrored = mirrors(matrices[i]);
    std::vector<glm::dvec4> tangents;
    if (scene_.materials[std::size_t(scene_.nodes[i].material)].normal_texture) tangents = tangents_of(mesh);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      const Vertex& vertex = mesh.vertices[v];
      corners_.push_back({glm::dvec3(matrices[i] * glm::dvec4(glm::dvec3(vertex.position), 1)),
                          world_normal(normal_matrix, glm::dvec3(vertex.normal)), glm::dvec2(vertex.texcoord),
                          tangents.empty() ? glm::dvec4(0) : world_tangent(matrices[i], mirrored, tangents[v])});
    }
    for (std::size_t at = 0; at + 2 < mesh.indices.size(); at += 3) {
      const std::uint32_t a = base + mesh.indices[at], b = base + mesh.indices[at + 1], c = base + mesh.indices[at + 2];
      add_triangle({{a, mirrored ? c : b, mirrored ? b : c}, int(i)});
    }
  }
}

/// Adds the part of a triangle that its node keeps.
void World::add_triangle(const Triangle& triangle) {
  const std::optional<glm::dvec4>& kept = scene_.nodes[std::size_t(triangle.node)].kept;
  if (!kept) {
    triangles_.push_back(triangle);
    return;
  }
  std::vector<std::uint32_t> part;  // a convex polygon
  const auto side_of = [&](std::uint32_t corner) { return glm::dot(*kept, glm::dvec4(corners_[corner].position, 1)); };
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t from = triangle.corners[i], to = triangle.corners[(i + 1) % 3];
    const double at_from = side_of(from), at_to = side_of(to);
    if (at_from >= 0) part.push_back(from);
    if ((at_from >= 0) == (at_to >= 0)) continue;
    const double t = at_from / (at_from - at_to);
    const Corner &a = corners_[from], &b = corners_[to];
    const Corner between{glm::mix(a.position, b.position, t), glm::mix(a.normal, b.normal, t),
                         glm::mix(a.texcoord, b.texcoord, t), glm::mix(a.tangent, b.tangent, t)};
    part.push_back(std::uint32_t(corners_.size()));
    corners_.push_back(between);
  }
  for (std::size_t i = 2; i < part.size(); ++i) triangles_.push_back({{part[0], part[i - 1], part[i]}, triangle.node});
}

void World::place_shapes(std::vector<Shape> shapes) {
  for (Shape& shape : shapes) {
    if (shape.material < 0 || std::size_t(shape.material) >= scene_.materials.size())
      throw Error(fmt::format("scene '{}': shape {}: material {} of {}", scene_.name, shapes_.size(), shape.material,
                              scene_.materials.size()));
    const glm::dmat4 inverse = glm::inverse(shape.object_to_world);
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row)
        if (!std::isfinite(inverse[column][row]))
          throw Error(fmt::format("scene '{}': shape {}: its matrix cannot be inverted", scene_.name, shapes_.size()));
    if (const auto* field = std::get_if<HeightField>(&shape.surface))
      validate(*field, fmt::format("scene '{}': shape {}", scene_.name, shapes_.size()));
    const glm::dmat3 normal_matrix = normal_matrix_exact(shape.object_to_world);
    const Box3 box = oracle::bounds(shape);
    const glm::dvec4 tangent = tangent_of(shape);
    shapes_.push_back({std::move(shape), inverse, normal_matrix, box, tangent});
  }
}

glm::dvec4 World::tangent_of(const Shape& shape) const {
  const Rectangle* base = base_of(shape.surface);
  if (!base || !scene_.materials[std::size_t(shape.material)].normal_texture) return glm::dvec4(0);
  return world_tangent(shape.object_to_world, mirrors(shape.object_to_world), {unit_or_zero(base->half_u), 1});
}

void World::build_tree() {
  std::vector<Box3> boxes;
  boxes.reserve(triangles_.size() + shapes_.size());
  for (const Triangle& triangle : triangles_) boxes.push_back(box_around(corners_of(triangle)));
  for (const PlacedShape& placed : shapes_) boxes.push_back(placed.box);
  for (const Box3& box : boxes)
    for (const glm::dvec3& far : {glm::abs(box.low), glm::abs(box.high)})
      reach_ = std::max({reach_, far.x, far.y, far.z});
  tree_ = Bvh(boxes);
}

// ---- Queries

/// t is the same in both spaces, since the direction is not normalised.
Ray World::ray_in_object_space(const PlacedShape& placed, const Ray& ray) const {
  return {glm::dvec3(placed.world_to_object * glm::dvec4(ray.origin, 1)),
          glm::dvec3(placed.world_to_object * glm::dvec4(ray.direction, 0)), ray.least, ray.most};
}

/// The nearest hit so far.
struct World::Found {
  double t;
  std::size_t thing = std::numeric_limits<std::size_t>::max();
  TriangleHit on_triangle;
  ShapeHit on_shape;

  bool nearer(double other, std::size_t index) const { return other < t || (other == t && index < thing); }
};

std::optional<SurfacePoint> World::seen(const Ray& ray) const {
  const ShearedRay sheared(ray);
  Found found{.t = ray.most};
  tree_.traverse(ray, found.t, [&](std::uint32_t index) {
    if (index < triangles_.size()) {
      const Triangle& triangle = triangles_[index];
      const auto [a, b, c] = corners_of(triangle);
      const auto hit = intersect(sheared, a, b, c);
      if (!hit || !found.nearer(hit->t, index)) return false;
      const Node& node = scene_.nodes[std::size_t(triangle.node)];
      if (!hit->front && !scene_.materials[std::size_t(node.material)].two_sided) return false;
      found.t = hit->t, found.thing = index, found.on_triangle = *hit;
    } else {
      const PlacedShape& placed = shapes_[index - triangles_.size()];
      const bool two_sided = scene_.materials[std::size_t(placed.shape.material)].two_sided;
      const auto hit = intersect(placed.shape.surface, ray_in_object_space(placed, ray), !two_sided);
      if (!hit || !found.nearer(hit->t, index)) return false;
      found.t = hit->t, found.thing = index, found.on_shape = *hit;
    }
    return false;
  });
  if (found.thing == std::numeric_limits<std::size_t>::max()) return std::nullopt;
  SurfacePoint point = found.thing < triangles_.size()
                           ? point_on_triangle(triangles_[found.thing], found.on_triangle)
                           : point_on_shape(found.thing - triangles_.size(), found.on_shape, ray);
  point.t = found.t;
  return point;
}

bool World::blocked(const Ray& ray) const {
  const ShearedRay sheared(ray);
  bool blocked = false;
  tree_.traverse(ray, ray.most,
                 [&](std::uint32_t thing) { return blocked = casts_shadow(thing) && meets(sheared, thing); });
  return blocked;
}

std::vector<std::uint32_t> World::casters_in(const Beam& beam) const {
  std::vector<std::uint32_t> found;
  tree_.visit([&](const Box3& box) { return beam.misses(box); },
              [&](std::uint32_t thing) {
                if (casts_shadow(thing) && may_meet(beam, thing)) found.push_back(thing);
              });
  return found;
}

bool World::may_meet(const Beam& beam, std::uint32_t thing) const {
  if (thing < triangles_.size()) return !beam.misses(corners_of(triangles_[thing]));
  const PlacedShape& placed = shapes_[thing - triangles_.size()];
  const auto* flat = std::get_if<Rectangle>(&placed.shape.surface);
  if (!flat) return !beam.misses(placed.box);
  std::array<glm::dvec3, 4> corners;
  const double along_u[] = {-1, 1, 1, -1}, along_v[] = {-1, -1, 1, 1};
  for (std::size_t i = 0; i < 4; ++i)
    corners[i] = glm::dvec3(placed.shape.object_to_world *
                            glm::dvec4(flat->centre + along_u[i] * flat->half_u + along_v[i] * flat->half_v, 1));
  return !beam.misses(corners);
}

bool World::meets(const ShearedRay& ray, std::uint32_t thing) const {
  if (thing < triangles_.size()) {
    const auto [a, b, c] = corners_of(triangles_[thing]);
    return intersect(ray, a, b, c).has_value();
  }
  const PlacedShape& placed = shapes_[thing - triangles_.size()];
  return intersect(placed.shape.surface, ray_in_object_space(placed, ray.ray()), false).has_value();
}

bool World::fills_between(std::uint32_t thing) const {
  return thing < triangles_.size() ||
         std::holds_alternative<Rectangle>(shapes_[thing - triangles_.size()].shape.surface);
}

bool World::casts_shadow(std::uint32_t thing) const {
  return thing < triangles_.size() ? scene_.nodes[std::size_t(triangles_[thing].node)].casts_shadow
                                   : shapes_[thing - triangles_.size()].shape.casts_shadow;
}

std::array<glm::dvec3, 3> World::corners_of(const Triangle& triangle) const {
  return {corners_[triangle.corners[0]].position, corners_[triangle.corners[1]].position,
          corners_[triangle.corners[2]].position};
}

SurfacePoint World::point_on_triangle(const Triangle& triangle, const TriangleHit& hit) const {
  const Corner &a = corners_[triangle.corners[0]], &b = corners_[triangle.corners[1]],
               &c = corners_[triangle.corners[2]];
  const Node& node = scene_.nodes[std::size_t(triangle.node)];
  const auto mix = [&](const auto& x, const auto& y, const auto& z) { return x + hit.b * (y - x) + hit.c * (z - x); };
  SurfacePoint point;
  point.position = mix(a.position, b.position, c.position);
  const glm::dvec3 normal = mix(a.normal, b.normal, c.normal);
  point.normal = unit_or_zero(normal);
  point.normal_length = glm::length(normal);
  point.tangent = mix(a.tangent, b.tangent, c.tangent);
  point.flat_normal = unit_or_zero(glm::cross(b.position - a.position, c.position - a.position));
  point.texcoord = mix(a.texcoord, b.texcoord, c.texcoord);
  point.material = node.material;
  point.thing = triangle.node;
  point.receives_shadow = node.receives_shadow;
  if (!hit.front) {
    // Seen from behind, a bump is a dent: the whole mapped normal turns round, so all its axes do. The bitangent is
    // w cross(N, T), hence w too.
    point.normal = -point.normal;
    point.flat_normal = -point.flat_normal;
    point.tangent = -point.tangent;
  }
  return point;
}

SurfacePoint World::point_on_shape(std::size_t index, const ShapeHit& hit, const Ray& ray) const {
  const PlacedShape& placed = shapes_[index];
  SurfacePoint point;
  point.position = ray.at(hit.t);
  point.flat_normal = point.normal = unit_or_zero(placed.normal_matrix * hit.normal);
  point.tangent = placed.tangent;
  if (const auto* field = std::get_if<HeightField>(&placed.shape.surface); field && point.tangent != glm::dvec4(0))
    point.normal = unit_or_zero(placed.normal_matrix * glm::cross(field->flat.half_u, field->flat.half_v));
  if (glm::dot(point.flat_normal, ray.direction) > 0) {  // two-sided, from behind: as on a triangle
    point.normal = -point.normal;
    point.flat_normal = -point.flat_normal;
    point.tangent = -point.tangent;
  }
  point.texcoord = hit.texcoord;
  point.material = placed.shape.material;
  point.thing = int(scene_.nodes.size() + index);
  point.receives_shadow = placed.shape.receives_shadow;
  return point;
}

}  // namespace atelier::oracle
