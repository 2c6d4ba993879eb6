// What is asked for of surfaces and lights, beside what the scene says: choices that every picture makes.
#pragma once

#include <functional>
#include <glm/glm.hpp>

#include "oracle/blinn_phong.hpp"
#include "oracle/world.hpp"

namespace atelier::oracle {

/// What of the light is asked for.
enum class Part {
  all,
  diffuse,   ///< ambient and diffuse light alone, without emission
  specular,  ///< the highlights alone
};

/// Whether things stand in each other's light. Lights, nodes and shapes say whether they take part.
enum class Shadows {
  none,
  hard,  ///< every light is a point, or a single direction
  soft,  ///< every light is a square: a point may see a part of it
};

/// A surface that is not Blinn-Phong: the colour of a point as seen from `eye`, linear. Called from several threads. It
/// may send rays of its own, or ask for `visibility` (oracle/shadow.hpp).
using SurfaceColour = std::function<glm::dvec3(const World& world, const SurfacePoint& point, const glm::dvec3& eye)>;

/// What of a light goes on to a position in world space, 0..1, past something thin that no node or shape stands for: a
/// screen, a pane. Called from several threads.
using LightShare = std::function<double(const Light& light, const glm::dvec3& position)>;

/// Choices that change what is asked for; light_samples alone trades accuracy for speed.
struct Shading {
  Normalisation normalisation = Normalisation::none;
  Shadows shadows = Shadows::none;
  double light_width =
      0;  ///< soft: the side of the square, 0..1e6 metres, or of a directional light tangents of angles
  int light_samples = 16;  ///< soft: n x n points of the square on a regular grid, 1..256
  LightShare share;        ///< set: multiplies how much of a light is seen, at points that receive shadows
  SurfaceColour surface;   ///< set: stands in for all of the above
};

/// Throws Error where the width or the number of samples of soft shadows is out of range.
void validate(const Shading& shading);

}  // namespace atelier::oracle
