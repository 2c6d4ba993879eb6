// Rays that go through portals and are reflected by mirrors.
#pragma once

#include <optional>
#include <vector>

#include "oracle/world.hpp"

namespace atelier::oracle {

/// From where a visitor is to where they come out, world space. `world`: the nodes' matrices.
glm::dmat4 passage_of(const Portal& portal, const std::vector<glm::dmat4>& world);

class Portals {
 public:
  /// Of a valid scene.
  explicit Portals(const Scene& scene);

  struct Opening {
    glm::dvec3 colour{0};   ///< what it shows where no ray goes through it
    glm::dmat4 through{1};  ///< from where a visitor is to where they come out: world space
    int exit = 0;           ///< the exit's node; a mirror's own
  };
  /// The opening that a point lies on, or null.
  const Opening* at(const SurfacePoint& point) const;

 private:
  std::vector<std::optional<Opening>> by_node_;
};

/// A ray from the eye, or from the last opening that it has gone through, to the next one.
struct Segment {
  Ray ray;                  ///< t runs on from segment to segment; surfaces are seen in the ray's interval
  double start = 0;         ///< t at the eye or at the last opening, at most ray.least: openings are met from here on
  std::optional<int> exit;  ///< the node that it has come out of. An opening on this node is in the plane in which the
                            ///< segment starts, and is not met again: not by rounding either
};

/// The first opening at start <= t < end, whatever surfaces stand before it. Only a two-sided one is met from behind.
std::optional<SurfacePoint> first_opening(const World& world, const Portals& portals, const Segment& segment,
                                          double end);

/// The first point that is seen: a surface in the ray's interval, or an opening, from the start on. So the near plane
/// cuts off surfaces, but no openings, or a visitor who goes through one would see behind it.
std::optional<SurfacePoint> first_seen(const World& world, const Portals& portals, const Segment& segment);

/// The segment after an opening that is met at t.
Segment beyond(const Portals::Opening& opening, const Segment& segment, double t);

}  // namespace atelier::oracle
