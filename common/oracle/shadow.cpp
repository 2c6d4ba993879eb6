#include "oracle/shadow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/error.hpp"

namespace atelier::oracle {

namespace {

constexpr int most_portals = 255;
constexpr int most_samples = 256;
constexpr double widest = 1e6;
constexpr double off_surface = 1e-12;  ///< relative to the lengths involved: a thousand rounding errors

double largest_component(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// A rectangle of the sample grid: first and last column and row, inclusive.
struct Cells {
  glm::ivec2 first, last;
  int count() const { return (last.x - first.x + 1) * (last.y - first.y + 1); }
};

/// The shadow rays from one point to one light.
class ShadowRays {
 public:
  ShadowRays(const World& world, const SurfacePoint& point, const Light& light, const Shading& shading);

  bool at_light() const { return window_.middle == glm::dvec3(0) && !window_.endless; }
  int samples() const { return samples_; }
  /// To the centre of a cell of the grid.
  Ray to(const glm::ivec2& cell) const;
  Beam beam(const Cells& cells) const { return {apex_, from_apex_, aside(cells.first), aside(cells.last), level_}; }

 private:
  /// Offset from the light's centre, along right and up.
  glm::dvec2 aside(const glm::ivec2& cell) const {
    return ((glm::dvec2(cell) + 0.5) / double(samples_) - 0.5) * width_;
  }

  glm::dvec3 apex_, normal_;  ///< where the rays start; the surface's normal, on the light's side
  Window window_;             ///< as seen from the point
  Window from_apex_;          ///< as seen from the apex
  double width_ = 0;
  double gap_ = 0;    ///< offset of the rays' start from the surface, metres
  double level_ = 0;  ///< a ray that rises less than this runs along the surface; metres, or radians for directions
  int samples_ = 1;
};

ShadowRays::ShadowRays(const World& world, const SurfacePoint& point, const Light& light, const Shading& shading) {
  const glm::dvec3 direction(light.direction), up(0, 1, 0);
  window_.endless = light.type == LightType::directional;
  window_.middle = window_.endless ? -glm::normalize(direction) : light.position - point.position;
  if (shading.shadows == Shadows::soft && shading.light_width > 0) {
    window_.frame = view_frame(light.type == LightType::point ? -window_.middle : direction, up);
    width_ = shading.light_width;
    samples_ = shading.light_samples;
  }
  // Positions have a relative error of some 1e-16 of the largest coordinates: start slightly off the surface, on the
  // light's side, to avoid self-shadowing.
  const double distance = window_.endless ? 0 : glm::length(window_.middle);
  gap_ = off_surface * (std::max(world.reach(), largest_component(point.position)) + distance);
  level_ = window_.endless ? off_surface : gap_;
  normal_ = glm::dot(point.flat_normal, window_.middle) < 0 ? -point.flat_normal : point.flat_normal;
  apex_ = point.position + gap_ * normal_;
  from_apex_ = window_;
  if (!window_.endless) from_apex_.middle -= gap_ * normal_;
}

Ray ShadowRays::to(const glm::ivec2& cell) const {
  const glm::dvec2 at = aside(cell);
  glm::dvec3 way = window_.middle + at.x * window_.frame.right + at.y * window_.frame.up;
  // Make a ray along the surface exactly parallel to it: otherwise rounding could make it hit the surface.
  const double climb = glm::dot(normal_, way);
  if (window_.endless) {
    if (std::abs(climb) < level_) way -= climb * normal_;
    return {apex_, way};
  }
  if (std::abs(climb) < level_) way += (gap_ - climb) * normal_;
  way -= gap_ * normal_;
  const double length = glm::length(way);
  return {apex_, way, 0,
          length > gap_ ? 1 - gap_ / length : 0};  // a surface that touches the light does not occlude it
}

/// Counts the cells that the point sees, one rectangle of cells at a time: all of it if nothing can occlude it, none of
/// it if a single flat primitive covers it. Single rays are traced only at shadow edges. The result equals that of a
/// ray to every cell.
class SeenCells {
 public:
  SeenCells(const World& world, const ShadowRays& rays) : world_(world), rays_(rays) {}

  int count() {
    const int last = rays_.samples() - 1;
    const Cells all{{0, 0}, {last, last}};
    things_ = world_.casters_in(rays_.beam(all));
    return count(all, 0, things_.size());
  }

 private:
  static constexpr int few = 8;  ///< with at most this many cells, single rays are cheaper than a beam

  /// `first` to `last`: range in things_ of the primitives that may occlude these cells.
  int count(const Cells& cells, std::size_t first, std::size_t last) {
    if (first == last) return cells.count();
    if (cells.count() <= few) return count_each(cells, first, last);
    if (covered(cells, first, last)) return 0;
    const glm::ivec2 middle = (cells.first + cells.last) / 2;
    int seen = 0;
    for (int quarter = 0; quarter < 4; ++quarter) {
      const bool right = (quarter & 1) != 0, upper = (quarter & 2) != 0;
      const Cells part{{right ? middle.x + 1 : cells.first.x, upper ? middle.y + 1 : cells.first.y},
                       {right ? cells.last.x : middle.x, upper ? cells.last.y : middle.y}};
      if (part.first.x > part.last.x || part.first.y > part.last.y) continue;
      const Beam beam = rays_.beam(part);
      for (std::size_t i = first; i < last; ++i)
        if (world_.may_meet(beam, things_[i])) things_.push_back(things_[i]);
      seen += count(part, last, things_.size());
      things_.resize(last);
    }
    return seen;
  }

  int count_each(const Cells& cells, std::size_t first, std::size_t last) const {
    int seen = 0;
    for (int y = cells.first.y; y <= cells.last.y; ++y)
      for (int x = cells.first.x; x <= cells.last.x; ++x) {
        const ShearedRay ray(rays_.to({x, y}));
        bool blocked = false;
        for (std::size_t i = first; i < last && !blocked; ++i) blocked = world_.meets(ray, things_[i]);
        seen += !blocked;
      }
    return seen;
  }

  bool covered(const Cells& cells, std::size_t first, std::size_t last) const {
    const ShearedRay corners[] = {ShearedRay(rays_.to(cells.first)), ShearedRay(rays_.to(cells.last)),
                                  ShearedRay(rays_.to({cells.first.x, cells.last.y})),
                                  ShearedRay(rays_.to({cells.last.x, cells.first.y}))};
    for (std::size_t i = first; i < last; ++i)
      if (world_.fills_between(things_[i]) &&
          std::ranges::all_of(corners, [&](const ShearedRay& ray) { return world_.meets(ray, things_[i]); }))
        return true;
    return false;
  }

  const World& world_;
  const ShadowRays& rays_;
  /// A stack of possible occluders: those of a rectangle on top of those of the enclosing rectangle.
  std::vector<std::uint32_t> things_;
};

}  // namespace

void validate(const Shading& shading) {
  if (shading.portal_depth < 0 || shading.portal_depth > most_portals)
    throw Error(fmt::format("{} portals one after another (allowed: 0 to {})", shading.portal_depth, most_portals));
  if (shading.shadows != Shadows::soft) return;
  if (shading.portal_lights && shading.light_width > 0)
    throw Error("soft shadows of light that goes through portals have no ground truth");
  if (!(shading.light_width >= 0 && shading.light_width <= widest))
    throw Error(fmt::format("a light {} wide (allowed: 0 to {})", shading.light_width, widest));
  if (shading.light_samples < 1 || shading.light_samples > most_samples)
    throw Error(fmt::format("{} x {} points on a light (allowed: 1 x 1 to {} x {})", shading.light_samples,
                            shading.light_samples, most_samples, most_samples));
}

namespace {

double seen_share(const World& world, const SurfacePoint& point, const Light& light, const Shading& shading) {
  if (shading.shadows == Shadows::none || !light.casts_shadow) return 1;
  const ShadowRays rays(world, point, light, shading);
  if (rays.at_light()) return 1;
  const int n = rays.samples();
  if (n == 1) return world.blocked(rays.to({0, 0})) ? 0 : 1;
  return SeenCells(world, rays).count() / (double(n) * n);
}

double transmitted(const Light& light, const glm::dvec3& position, const LightShare& share) {
  const double found = share(light, position);
  if (!(found >= 0 && found <= 1))
    throw Error(fmt::format("a share {} of light '{}' (allowed: 0 to 1)", found, light.name));
  return found;
}

}  // namespace

double visibility(const World& world, const SurfacePoint& point, const Light& light, const Shading& shading) {
  validate(shading);
  if (!point.receives_shadow) return 1;
  const double seen = seen_share(world, point, light, shading);
  return shading.share ? seen * transmitted(light, point.position, shading.share) : seen;
}

double visibility(const World& world, const SurfacePoint& point, const LightImage& image, const Shading& shading) {
  validate(shading);
  const bool endless = image.light.type == LightType::directional;
  const double gap = off_surface * (std::max(world.reach(), largest_component(point.position)) +
                                    (endless ? 0 : largest_component(image.light.position)));
  const glm::dvec3 towards = endless ? -glm::dvec3(image.light.direction) : image.light.position - point.position;
  const bool above = glm::dot(point.flat_normal, towards) >= 0;
  const auto way = way_to(image, point.position + (above ? gap : -gap) * point.flat_normal, 10 * gap);
  if (!way) return 0;
  if (shading.shadows == Shadows::none || !image.light.casts_shadow || !point.receives_shadow) return 1;
  return world.blocked(way->to_exit) || world.blocked(way->to_light) ? 0 : 1;
}

}  // namespace atelier::oracle
