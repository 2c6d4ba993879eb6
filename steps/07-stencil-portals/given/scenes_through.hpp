// Scenes of step 07 in which more than the eye goes through a door: light, bodies, particles. Given.
#pragma once

#include "scene/scene.hpp"

namespace atelier {

/// A dark room, lit only by the light that comes through a door from another one. A mirror there throws some light
/// back. Posts on both sides cast shadows.
Scene make_lamp_scene();

/// A body in a door, lit on both sides. `way`: 0 it is before the door, 1 behind.
Scene make_astride_scene(double way);

/// Glowing particles swirl through two doors at dusk, from the rim of one into it, and out of the other. `time`: 0..1,
/// periodic.
Scene make_swirl_scene(int particles, double time);

}  // namespace atelier
