// Camera rays and depth values.
#pragma once

#include <glm/glm.hpp>

#include "oracle/frame.hpp"
#include "oracle/ray.hpp"
#include "scene/scene.hpp"

namespace atelier::oracle {

class CameraRays {
 public:
  /// For a picture of `size` pixels, whose vertical extent is camera.fov_y (or camera.height); the horizontal one
  /// follows from the aspect ratio. Right and up are those of view_frame(target - eye, up).
  CameraRays(const Camera& camera, const glm::ivec2& size);

  /// The ray through a point of the picture, in pixels from its upper left corner: (x + 0.5, y + 0.5) is the centre of
  /// pixel (x, y), where OpenGL samples. t is the distance along the axis; the ray's interval is from the near plane to
  /// the far plane.
  Ray through(const glm::dvec2& pixel) const;

  /// The ray from the eye in a direction of view space: x right, y up, -z ahead. t is the distance along the axis for
  /// directions whose z is -1.
  Ray along(const glm::dvec3& direction) const;

  /// The depth that OpenGL stores at distance z along the axis: 0 at the near plane, 1 at the far plane;
  ///   perspective    f (z - n) / (z (f - n))        reversed:  n (f - z) / (z (f - n))
  ///   orthographic   (z - n) / (f - n)              reversed:  (f - z) / (f - n)
  double depth(double z, bool reversed) const;

  const glm::dvec3& eye() const { return eye_; }

 private:
  bool orthographic_;
  glm::dvec3 eye_;
  ViewFrame frame_;
  glm::dvec2 size_, half_;  ///< pixels; half extents of the view: metres, or tangents of angles
  double near_, far_;
};

}  // namespace atelier::oracle
