// Shading options of a picture, beside the scene.
#pragma once

#include <functional>
#include <glm/glm.hpp>

#include "oracle/blinn_phong.hpp"
#include "oracle/world.hpp"

namespace atelier::oracle {

/// Which part of the light is computed.
enum class Part {
  all,
  diffuse,   ///< only ambient and diffuse light, without emission
  specular,  ///< only the highlights
};

/// Shadows. Lights, nodes and shapes have flags that exclude them.
enum class Shadows {
  none,
  hard,  ///< every light is a point or a single direction
  soft,  ///< every light is a square, which may be partly visible
};

/// A shading model other than Blinn-Phong: the linear colour of a point as seen from `eye`. Called from several
/// threads. It may trace rays of its own, or call `visibility` (oracle/shadow.hpp).
using SurfaceColour = std::function<glm::dvec3(const World& world, const SurfacePoint& point, const glm::dvec3& eye)>;

/// The fraction of a light, 0..1, that reaches a position in world space through a thin object that is not in the
/// scene, such as a blind. Called from several threads.
using LightShare = std::function<double(const Light& light, const glm::dvec3& position)>;

/// Options that change the picture; only light_samples trades accuracy for speed.
struct Shading {
  Normalisation normalisation = Normalisation::none;
  Shadows shadows = Shadows::none;
  double light_width = 0;    ///< soft: side of the square, 0..1e6 metres; for a directional light, tangent of an angle
  int light_samples = 16;    ///< soft: n x n points of the square on a regular grid, 1..256
  bool normal_maps = false;  ///< whether normal textures change the normal (oracle/normal_map.hpp), also as output
  int portal_depth = 0;  ///< how many portals and mirrors one after another a ray of the camera goes through, 0..255
  bool portal_lights = false;  ///< light also goes through one portal, or is reflected by one mirror
  LightShare share;            ///< if set, multiplies the visible fraction of a light, at points that receive shadows
  SurfaceColour surface;       ///< if set, replaces all of the above
};

/// Throws Error if the portal depth, or the width or the number of samples of soft shadows is out of range.
void validate(const Shading& shading);

}  // namespace atelier::oracle
