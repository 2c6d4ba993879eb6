// A camera and a light for models without them.
#pragma once

#include "scene/scene.hpp"

namespace atelier::scene_import {

/// A camera in front of the model, a little to the right and above, that sees the sphere around `box` in a picture at
/// least as wide as high, with tight near and far planes.
Camera camera_around(const Box3& box);

/// Completes a file's camera without far plane or target: near and far around the box as seen from there, the target at
/// the box's depth.
void fit_depth(Camera& camera, const Box3& box);

/// A white directional light from above and to the left of the camera.
Light key_light(const Camera& camera);

}  // namespace atelier::scene_import
