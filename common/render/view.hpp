// A view: the camera of a drawing and its options.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "scene/scene.hpp"

namespace atelier {

/// One drawing of a scene.
struct View {
  Camera camera;
  std::string output = "colour";  ///< "colour", an intermediate result, or the name of a pass of the chain
  bool wireframe = false;         ///< edges only
  bool camera_relative = false;   ///< the world is moved so that the eye is its origin, in double precision
  bool cull = false;              ///< skip nodes whose boxes are outside the view
  bool passes = true;             ///< whether post-processing follows
  bool reversed_depth = false;    ///< depth 1 at the near plane; needs clip control and a float depth buffer

  // If set, they replace the camera's matrices: for the virtual camera of a portal or a mirror. In the shaders' world
  // space.
  std::optional<glm::mat4> world_to_view;
  std::optional<glm::mat4> projection;
  std::optional<glm::dvec3> eye;  ///< of world_to_view, if its float matrix is not exact enough: absolute world space
  bool mirrored = false;          ///< world_to_view has an odd number of reflections: front faces are clockwise

  // Bounds of the view in the target and in the world.
  std::optional<glm::ivec4> scissor;  ///< pixels: x, y of the lower left corner, width, height
  std::optional<glm::dvec4>
      clip_plane;  ///< absolute world space: points of surfaces with dot(plane, (p, 1)) < 0 are clipped
  std::optional<glm::dvec4> openings_clip_plane;  ///< the same for the openings of views inside this one
  int stencil_level = 0;                          ///< above 0: drawn only where the stencil buffer holds this number
  const View* parent = nullptr;                   ///< the enclosing view; null: this view has its own target
};

/// A view with derived data for features, in the shaders' world space (relative to the eye if the view is
/// camera-relative; a nested view has the outermost one's origin).
struct Viewpoint {
  const View& view;
  glm::mat4 world_to_view, projection;
  glm::vec3 eye;
  glm::dvec3 origin{0};     ///< what was subtracted from the world
  glm::dvec3 exact_eye{0};  ///< absolute world space
};

/// The number of enclosing views.
inline int nesting_depth(const View& view) {
  int depth = 0;
  for (const View* around = view.parent; around; around = around->parent) ++depth;
  return depth;
}

}  // namespace atelier
