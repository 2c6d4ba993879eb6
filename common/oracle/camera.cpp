#include "oracle/camera.hpp"

#include <cmath>

namespace atelier::oracle {

namespace {

glm::dvec3 direction_of_view(const Camera& camera) {
  return camera.eye == camera.target ? glm::dvec3(0, 0, -1) : glm::normalize(camera.target - camera.eye);
}

glm::dvec3 axis_least_along(const glm::dvec3& direction) {
  const glm::dvec3 size = glm::abs(direction);
  if (size.x <= size.y && size.x <= size.z) return {1, 0, 0};
  return size.y <= size.z ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
}

}  // namespace

CameraRays::CameraRays(const Camera& camera, const glm::ivec2& size)
    : orthographic_(camera.projection == Projection::orthographic),
      eye_(camera.eye),
      ahead_(direction_of_view(camera)),
      size_(size),
      near_(camera.near),
      far_(camera.far) {
  const glm::dvec3 up(camera.up);
  right_ = glm::cross(ahead_, up);
  // Parallel to a float's accuracy: the cameras that are compared with this one work in floats.
  if (glm::length(right_) <= 1e-6 * glm::length(up)) right_ = glm::cross(ahead_, axis_least_along(ahead_));
  right_ = glm::normalize(right_);
  up_ = glm::cross(right_, ahead_);
  const double above = orthographic_ ? double(camera.height) / 2 : std::tan(double(camera.fov_y) / 2);
  half_ = {above * size_.x / size_.y, above};
}

Ray CameraRays::through(const glm::dvec2& pixel) const {
  const glm::dvec2 place = (pixel / size_ * 2.0 - 1.0) * half_;  // down the picture is down in space: y turns
  const glm::dvec3 aside = place.x * right_ - place.y * up_;
  if (orthographic_) return {eye_ + aside, ahead_, near_, far_};
  return {eye_, ahead_ + aside, near_, far_};
}

double CameraRays::depth(double z, bool reversed) const {
  if (orthographic_) return (reversed ? far_ - z : z - near_) / (far_ - near_);
  if (reversed) return std::isinf(far_) ? near_ / z : near_ * (far_ - z) / (z * (far_ - near_));
  return std::isinf(far_) ? 1 - near_ / z : far_ * (z - near_) / (z * (far_ - near_));
}

}  // namespace atelier::oracle
