// A camera that turns about a point: what a mouse does to it, as pure functions.
//
// The eye stands on a sphere about the target. Two angles say where: the heading runs round the axis `up` like a
// longitude, the elevation leads towards it like a latitude. The camera stays upright because the elevation stops short
// of the poles. Everything is double: at a million metres from the origin a float could not tell two millimetres apart.
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

/// How close to a pole a turn may lead: there the heading loses its meaning and the picture would spin.
inline constexpr double highest_elevation = 1.5690;  // radians; 89.9 degrees

/// The orbit that a camera stands on, with bounds at a thousandth and a thousand times its distance. A camera without
/// an `up` gets +y; an eye in its own target is moved one metre back.
Orbit orbit_of(const Camera& camera);

/// Where the eye is.
glm::dvec3 eye_of(const Orbit& orbit);

/// `camera` moved to where the orbit has led it; `start` is the orbit that it stood on. An orthographic camera sees
/// more or less as the distance grows or shrinks: it has no perspective to show that otherwise.
Camera camera_on(const Orbit& orbit, const Camera& camera, const Orbit& start);

// Each of the following leaves the orbit as it was where an argument is not finite.

/// Turns by radians: `heading` to the right of the picture, `elevation` towards the pole.
Orbit turned(Orbit orbit, double heading, double elevation);

/// Moves nearer by `steps` of a wheel, a tenth of the distance each; negative ones lead away.
Orbit dollied(Orbit orbit, double steps);

/// Moves target and eye together so that what is `pixels` away from the cursor (x to the right, y down) comes under it;
/// `metres_per_pixel` is measured at the target.
Orbit panned(Orbit orbit, glm::dvec2 pixels, double metres_per_pixel);

/// How large a pixel is at the target, for a picture `height` pixels high.
double metres_per_pixel(const Orbit& orbit, const Camera& camera, double height);

}  // namespace atelier
