#include "04-point-shadows/given/light_cones.hpp"

#include <algorithm>

#include "04-point-shadows/point_shadows.hpp"

namespace atelier {

namespace {

/// Around each caster.
std::vector<shadow_mapping::Sphere> caster_spheres(const Scene& scene, std::span<const ScenePainter::Item> items) {
  std::vector<shadow_mapping::Sphere> spheres;
  for (const ScenePainter::Item& item : items)
    if (casts(scene, item) && !item.box.empty())
      if (const auto sphere = sphere_around(corners_of(item))) spheres.push_back(*sphere);
  return spheres;
}

std::optional<shadow_mapping::LightFrustum> frustum_around(const glm::vec3& position,
                                                           const std::vector<shadow_mapping::Sphere>& spheres) {
  // Radians, 63 degrees: up to 68 degrees (tangent sqrt(6)) a map has finer texels than a cube with as many.
  constexpr float widest = 1.1f;
  const auto cone = point_shadows::cone_around(position, spheres, widest);
  if (!cone) return {};
  float near = 1e30f, far = 0;
  for (const shadow_mapping::Sphere& sphere : spheres) {
    const float depth = glm::dot(sphere.centre - position, cone->axis);
    near = std::min(near, depth - sphere.radius);
    far = std::max(far, depth + sphere.radius);
  }
  return shadow_mapping::LightFrustum{.eye = position,
                                      .direction = cone->axis,
                                      .extent = std::max(cone->half_angle, 1e-3f),
                                      .near = std::max(0.99f * near, far / 1000),
                                      .far = far};
}

}  // namespace

void LightCones::configure(const Settings& settings) {
  wanted_ = settings.choice("cube.instead") == "cone";
  keep_ = shadow_settings(settings).keep;
}

void LightCones::draw_before(Gl&, const Scene& scene, const Viewpoint& viewpoint, ScenePainter& painter) {
  if (!shows_shadows(viewpoint.view) || (found_ && keep_ && !viewpoint.view.camera_relative)) return;
  frusta_.clear();
  found_ = true;
  if (!wanted_) return;
  const std::vector<shadow_mapping::Sphere> spheres = caster_spheres(scene, painter.items());
  for (const int light : lights_.points) {
    const Light& source = lights_.light(light);
    if (!source.casts_shadow || source.passage || spheres.empty()) continue;
    if (const auto frustum = frustum_around(glm::vec3(source.position - viewpoint.origin), spheres))
      frusta_.emplace(light, *frustum);
  }
}

}  // namespace atelier
