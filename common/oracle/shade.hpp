// The colour of a point of a surface: every light of the scene, and what the surface makes of it.
#pragma once

#include <functional>

#include "oracle/blinn_phong.hpp"
#include "oracle/world.hpp"

namespace atelier::oracle {

/// What of the light is asked for.
enum class Part {
  all,
  diffuse,   ///< ambient and diffuse light alone, without emission
  specular,  ///< the highlights alone
};

/// A surface that is not Blinn-Phong: the colour of a point as seen from `eye`, linear. Called from several threads.
using SurfaceColour = std::function<glm::dvec3(const Scene& scene, const SurfacePoint& point, const glm::dvec3& eye)>;

/// Choices that change what is asked for, none of which trades accuracy for anything.
struct Shading {
  Normalisation normalisation = Normalisation::none;
  bool hard_shadows = false;  ///< lights, nodes and shapes say whether they take part
  SurfaceColour surface;      ///< set: stands in for all of the above
};

/// The linear colour of a point as seen from `eye`:
///   kd ambient + emission + sum over lights of Arriving::amount * reflected(...)
/// A point without a normal, or with the eye upon it, has no direction to reflect in: ambient and emission are all.
glm::dvec3 shade(const World& world, const SurfacePoint& point, const glm::dvec3& eye, const Shading& shading,
                 Part part = Part::all);

/// The material of a point with its textures looked up.
Reflectance reflectance_at(const Scene& scene, const SurfacePoint& point);

/// Whether something that casts shadows stands between a point and a light that does.
bool in_shadow(const World& world, const SurfacePoint& point, const Light& light);

}  // namespace atelier::oracle
