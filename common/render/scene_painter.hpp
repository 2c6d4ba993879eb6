// The renderer's interface for features that draw: nodes with their own programs, and whole views.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <tuple>

#include "gl/target.hpp"
#include "render/binder.hpp"
#include "render/target_pool.hpp"
#include "render/view.hpp"

namespace atelier {

/// The stages of a feature's own program for drawing nodes: GLSL texts of #include lines and code. The renderer puts
/// before the vertex stage the attributes, the uniforms u_model, u_view and u_projection, and step 01's functions.
struct PassSources {
  std::string name;  ///< for messages
  std::string vertex, fragment;
  std::string geometry;  ///< empty: none
  Defines structure;     ///< #defines of all stages
  bool operator<(const PassSources& other) const {
    return std::tie(vertex, geometry, fragment, structure) <
           std::tie(other.vertex, other.geometry, other.fragment, other.structure);
  }
};

/// The functions of step 07 that the renderer calls for nested views. The feature itself computes the virtual camera
/// and the clipped projection, and passes their matrices in the View. Clipping with clip distances is View::clip_plane,
/// with discarded fragments the slot discard_fragment. Both functions are called with default OpenGL state plus the
/// scissor, clip distance and depth test of the enclosing view; the surface of the opening is drawn right after each.
struct NestingFunctions {
  /// Marking: the visible pixels of the opening raise the stencil buffer from `level` to level + 1. Changes neither
  /// colour nor depth.
  void (*begin_mark)(Gl& gl, int level) = nullptr;
  /// Unmarking: where the stencil buffer holds level + 1, writes the opening's own depth unconditionally and lowers the
  /// stencil buffer to `level`. Changes no colour.
  void (*begin_restore)(Gl& gl, int level) = nullptr;
};

class ScenePainter {
 public:
  /// A node with a mesh, with its matrices in the shaders' world space from step 01's functions.
  struct Item {
    int node = 0;  ///< index into Scene::nodes
    glm::mat4 model{1.0f};
    glm::mat3 normal_matrix{1.0f};
    bool mirrored = false;          ///< whether `model` mirrors: front faces are clockwise
    Box3 box;                       ///< of the mesh: object space
    std::optional<glm::vec4> kept;  ///< Node::kept
  };
  virtual ~ScenePainter() = default;

  /// Of the current view. A view with another origin (see Viewpoint) recomputes them.
  virtual std::span<const Item> items() const = 0;

  /// Draws items (by index in `items()`) with the pass's program into the bound framebuffer; calls `bind` to set its
  /// uniforms, once for all whole nodes and once for all that end at a plane (Node::kept; a pass with a geometry stage
  /// draws them whole). Sets the winding of front faces, reversed for mirrored nodes; the caller sets culling, depth
  /// test and viewport.
  virtual void paint(const PassSources& pass, std::span<const int> items, const std::function<void(Binder&)>& bind) = 0;

  /// Draws a view into a target of the feature's own, like `render`: a preview, the face of a cube. Call it from
  /// Feature::draw_views.
  virtual void draw_view(const View& view, const Target& target) = 0;

  /// Targets for such views, which are pooled and reused.
  virtual TargetPool& targets() = 0;

  /// Draws a view inside another one, at the visible pixels of the item `opening`: marks them in the stencil buffer,
  /// clears them to the background and the farthest depth, draws, and restores the opening's depth and the stencil
  /// value. Sets the view's parent and stencil level from `around`; its scissor should bound the opening. Call it from
  /// Feature::draw_inside. Throws Error if the target has no stencil buffer, or all 255 levels are in use.
  virtual void draw_view_inside(View view, const Viewpoint& around, const Target& target, int opening,
                                const NestingFunctions& functions) = 0;

  /// Fills an opening with one colour instead, at its own depth. Call it from Feature::draw_inside.
  virtual void fill_opening(const Viewpoint& around, const Target& target, int opening, const glm::vec3& colour) = 0;
};

}  // namespace atelier
