#include "app/window/orbit.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace atelier {
namespace {

constexpr double step_ratio = 0.9;  ///< factor of the distance per wheel step

/// A right-handed frame about `up`: heading 0 points along `front`, a quarter turn later along `side`.
struct Frame3 {
  glm::dvec3 side, up, front;
};

Frame3 frame_about(const glm::dvec3& up) {
  // +z, or +x if `up` is along z, so that the cross products are far from zero.
  const glm::dvec3 hint = std::abs(up.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  const glm::dvec3 side = glm::normalize(glm::cross(up, hint));
  return {side, up, glm::cross(side, up)};
}

/// From the target to the eye, unit length.
glm::dvec3 direction_of(const Orbit& orbit) {
  const Frame3 frame = frame_about(orbit.up);
  const double across = std::cos(orbit.elevation);
  return frame.side * (across * std::sin(orbit.heading)) + frame.front * (across * std::cos(orbit.heading)) +
         frame.up * std::sin(orbit.elevation);
}

bool finite(std::initializer_list<double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace

Orbit orbit_of(const Camera& camera) {
  Orbit orbit{.target = camera.target};
  const glm::dvec3 up = camera.up, arm = camera.eye - camera.target;
  if (glm::length(up) > 0) orbit.up = glm::normalize(up);
  const Frame3 frame = frame_about(orbit.up);
  const double length = glm::length(arm);
  if (length > 0) {
    // atan2 of both components: asin of the height would lose half its digits near the poles.
    const double side = glm::dot(arm, frame.side), front = glm::dot(arm, frame.front);
    orbit.heading = std::atan2(side, front);
    orbit.elevation = std::atan2(glm::dot(arm, frame.up), std::hypot(side, front));
  }
  orbit.distance = length > 0 ? length : 1;
  orbit.nearest = orbit.distance * 1e-3;
  orbit.farthest = orbit.distance * 1e3;
  return orbit;
}

glm::dvec3 eye_of(const Orbit& orbit) {
  return orbit.target + direction_of(orbit) * orbit.distance;
}

Camera camera_on(const Orbit& orbit, const Camera& camera, const Orbit& start) {
  Camera moved = camera;
  moved.eye = eye_of(orbit);
  moved.target = orbit.target;
  moved.height = float(camera.height * (orbit.distance / start.distance));
  return moved;
}

Orbit turned(Orbit orbit, double heading, double elevation) {
  if (!finite({heading, elevation})) return orbit;
  orbit.heading = std::remainder(orbit.heading + heading, glm::two_pi<double>());
  orbit.elevation = std::clamp(orbit.elevation + elevation, -highest_elevation, highest_elevation);
  return orbit;
}

Orbit dollied(Orbit orbit, double steps) {
  if (!finite({steps})) return orbit;
  orbit.distance = std::clamp(orbit.distance * std::pow(step_ratio, steps), orbit.nearest, orbit.farthest);
  return orbit;
}

Orbit panned(Orbit orbit, glm::dvec2 pixels, double size) {
  if (!finite({pixels.x, pixels.y, size})) return orbit;
  const glm::dvec3 forward = -direction_of(orbit);
  // The frame's side, rotated by the heading: correct even if the eye is at a pole.
  const Frame3 frame = frame_about(orbit.up);
  const glm::dvec3 right = frame.side * std::cos(orbit.heading) - frame.front * std::sin(orbit.heading);
  const glm::dvec3 above = glm::cross(right, forward);
  orbit.target += (above * pixels.y - right * pixels.x) * size;
  return orbit;
}

double metres_per_pixel(const Orbit& orbit, const Camera& camera, double height) {
  const double seen = camera.projection == Projection::orthographic ? double(camera.height)
                                                                    : 2 * orbit.distance * std::tan(camera.fov_y / 2.0);
  return seen / std::max(height, 1.0);
}

}  // namespace atelier
