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
  };
  /// The opening that a point lies on, or null.
  const Opening* at(const SurfacePoint& point) const;

 private:
  std::vector<std::optional<Opening>> by_node_;
};

/// The rest of a ray after an opening that it has met at t: it goes on from there, where its interval allows.
Ray beyond(const Portals::Opening& opening, const Ray& ray, double t);

}  // namespace atelier::oracle
