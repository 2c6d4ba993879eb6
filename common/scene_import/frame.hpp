// A camera and a light for models that bring none.
#pragma once

#include "scene/scene.hpp"

namespace atelier::scene_import {

/// A camera before the model, a little from the right and above, that sees the sphere around `box` in a picture at
/// least as wide as high, with near and far planes close around it.
Camera camera_around(const Box3& box);

/// The same for a camera that a file placed without saying how far it sees (or what it looks at): near and far around
/// the box as seen from there, the target at the box's depth.
void fit_depth(Camera& camera, const Box3& box);

/// White light over the camera's left shoulder, from infinitely far.
Light key_light(const Camera& camera);

}  // namespace atelier::scene_import
