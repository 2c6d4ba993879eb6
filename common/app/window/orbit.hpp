// An orbit camera, as pure functions.
//
// The eye is on a sphere around the target, given by two angles: the heading about the axis `up`, like a longitude, and
// the elevation towards it, like a latitude. The elevation stops short of the poles, so the camera stays upright.
// Everything is double: at a million metres from the origin floats have steps of centimetres.
#pragma once

#include "scene/scene.hpp"

namespace atelier {

struct Orbit {
  glm::dvec3 target{0};    ///< world space, metres
  glm::dvec3 up{0, 1, 0};  ///< unit length
  double distance = 5;     ///< from target to eye, metres, within nearest..farthest
  double heading = 0;      ///< radians, -pi..pi, counter-clockwise seen against `up`; for up = +y, 0 is +z and pi/2 +x
  double elevation = 0;    ///< radians above the plane across `up`
  double nearest = 5e-3, farthest = 5e3;  ///< bounds of `distance`, metres
};

/// Limit of the elevation: at a pole the heading is undefined and the picture would spin.
inline constexpr double highest_elevation = 1.5690;  // radians; 89.9 degrees

/// The orbit of a camera, with bounds at 1/1000 and 1000 times its distance. A camera without an `up` gets +y; an eye
/// at its target is moved one metre back.
Orbit orbit_of(const Camera& camera);

/// Where the eye is.
glm::dvec3 eye_of(const Orbit& orbit);

/// `camera` moved to `orbit`; `start` is its original orbit. For an orthographic camera the height of the view changes
/// with the distance, since there is no perspective.
Camera camera_on(const Orbit& orbit, const Camera& camera, const Orbit& start);

// The following functions return the orbit unchanged if an argument is not finite.

/// Rotates by radians: `heading` to the right of the picture, `elevation` towards the pole.
Orbit turned(Orbit orbit, double heading, double elevation);

/// Moves closer by `steps` of a wheel, a tenth of the distance each; negative steps move away.
Orbit dollied(Orbit orbit, double steps);

/// Moves target and eye so that the picture moves by `pixels` (x to the right, y down); `metres_per_pixel` is measured
/// at the target.
Orbit panned(Orbit orbit, glm::dvec2 pixels, double metres_per_pixel);

/// The size of a pixel at the target, for a picture `height` pixels high.
double metres_per_pixel(const Orbit& orbit, const Camera& camera, double height);

}  // namespace atelier
