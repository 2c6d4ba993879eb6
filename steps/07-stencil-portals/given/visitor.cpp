#include "07-stencil-portals/given/visitor.hpp"

#include <algorithm>
#include <optional>

#include "07-stencil-portals/given/openings.hpp"
#include "07-stencil-portals/given/scenes.hpp"
#include "07-stencil-portals/stencil_portals.hpp"

namespace atelier {

std::vector<SettingSpec> visitor_settings() {
  return {{.name = "visitor.way",
           .fallback = 0.0,
           .low = 0,
           .high = 1,
           .help = "how far the visitor has gone: 0 at the camera, 1 at the end of the scene's walk"}};
}

namespace {

Camera moved(Camera camera, const glm::dvec3& by) {
  camera.eye += by;
  camera.target += by;
  return camera;
}

/// Whether the way from `from` to `to` leads through an opening.
bool enters(const Opening& opening, const glm::dvec3& from, const glm::dvec3& to) {
  using stencil_portals::goes_through;
  if (goes_through(opening.frame, opening.half_size, from, to)) return true;
  return opening.two_sided && goes_through(from_behind(opening.frame), opening.half_size, from, to);
}

}  // namespace

Camera visit(const Scene& scene, const Camera& camera, const Settings& settings) {
  constexpr int steps = 64;  // of a whole walk
  const double way = settings.real("visitor.way") * steps;
  glm::dvec3 step = walk_of(scene) / double(steps);
  if (way == 0 || step == glm::dvec3(0)) return camera;
  const std::vector<Opening> openings = openings_of(scene);
  Camera now = camera;
  std::optional<int> exit;  // whose opening lies behind a visitor who goes straight on, whatever rounding says
  for (int i = 0; i < way; ++i) {
    const Camera next = moved(now, step * std::min(1.0, way - i));
    const auto met = std::ranges::find_if(openings, [&](const Opening& opening) {
      return !opening.mirror && opening.node != exit && enters(opening, now.eye, next.eye);
    });
    now = next;
    if (met == openings.end()) continue;
    exit = met->exit_node;
    now = stencil_portals::carried(now, met->passage);
    step = glm::dmat3(met->passage) * step;
  }
  return now;
}

}  // namespace atelier
