#include "oracle/camera.hpp"

#include <cmath>

namespace atelier::oracle {

CameraRays::CameraRays(const Camera& camera, const glm::ivec2& size)
    : orthographic_(camera.projection == Projection::orthographic),
      eye_(camera.eye),
      frame_(view_frame(camera.target - camera.eye, glm::dvec3(camera.up))),
      size_(size),
      near_(camera.near),
      far_(camera.far) {
  const double above = orthographic_ ? double(camera.height) / 2 : std::tan(double(camera.fov_y) / 2);
  half_ = {above * size_.x / size_.y, above};
}

Ray CameraRays::through(const glm::dvec2& pixel) const {
  const glm::dvec2 place = (pixel / size_ * 2.0 - 1.0) * half_;  // pixel y runs down: flip y
  const glm::dvec3 aside = place.x * frame_.right - place.y * frame_.up;
  if (orthographic_) return {eye_ + aside, frame_.ahead, near_, far_};
  return {eye_, frame_.ahead + aside, near_, far_};
}

Ray CameraRays::along(const glm::dvec3& direction) const {
  return {eye_, direction.x * frame_.right + direction.y * frame_.up - direction.z * frame_.ahead, near_, far_};
}

double CameraRays::depth(double z, bool reversed) const {
  if (orthographic_) return (reversed ? far_ - z : z - near_) / (far_ - near_);
  if (reversed) return std::isinf(far_) ? near_ / z : near_ * (far_ - z) / (z * (far_ - near_));
  return std::isinf(far_) ? 1 - near_ / z : far_ * (z - near_) / (z * (far_ - near_));
}

}  // namespace atelier::oracle
