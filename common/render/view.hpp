// From where a scene is seen, and what of it is drawn.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "scene/scene.hpp"

namespace atelier {

/// One traversal of a scene.
struct View {
  Camera camera;
  std::string output = "colour";  ///< "colour", one intermediate, or the name of a pass of the chain
  bool wireframe = false;         ///< edges only
  bool camera_relative = false;   ///< the world is moved so that the eye is its origin, in double precision
  bool cull = false;              ///< leave out nodes whose boxes are outside the view
  bool reversed_depth = false;    ///< depth 1 at the near plane; needs clip control and a float depth buffer

  // In place of what the camera gives: the virtual camera of a portal or a mirror. In the space that shaders call
  // world.
  std::optional<glm::mat4> world_to_view;
  std::optional<glm::mat4> projection;
  bool mirrored = false;  ///< an odd number of reflections is in world_to_view: front faces are clockwise

  // What of the target, and of the world, the view is bounded to.
  std::optional<glm::ivec4> scissor;     ///< pixels: x, y of the lower left corner, width, height
  std::optional<glm::dvec4> clip_plane;  ///< absolute world space: what has dot(plane, (p, 1)) < 0 is left out
  int stencil_level = 0;                 ///< above 0: drawn only where the stencil buffer holds this number
  const View* parent = nullptr;  ///< the view in whose picture this one lies; none: it has its target for itself
};

/// A view with everything that the features need to know about it worked out, in the space that shaders call world
/// (moved to the eye where the view is camera-relative; a view inside another has the outermost one's origin).
struct Viewpoint {
  const View& view;
  glm::mat4 world_to_view, projection;
  glm::vec3 eye;
  glm::dvec3 origin{0};  ///< what was subtracted from the world
};

/// How many views lie around this one.
inline int nesting_depth(const View& view) {
  int depth = 0;
  for (const View* around = view.parent; around; around = around->parent) ++depth;
  return depth;
}

}  // namespace atelier
