// What the renderer does for a feature that draws: nodes with programs of its own, and whole views.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <tuple>

#include "gl/target.hpp"
#include "render/binder.hpp"
#include "render/target_pool.hpp"
#include "render/view.hpp"

namespace atelier {

/// The stages of a program that a feature draws nodes with for itself: GLSL texts of #include lines and code. The
/// vertex stage begins with the attributes and the uniforms u_model, u_view and u_projection declared and step 01's
/// functions included.
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

/// What a step teaches of views inside views, as the renderer calls it. The virtual camera and the clipped projection
/// are not among it: a feature calls its step's functions itself, and hands their matrices over in the View. Clipping
/// by distances is given (View::clip_plane), clipping by discarded fragments is the slot discard_fragment. Both find
/// OpenGL's usual state, with the scissor and the stencil test of the view around; the surface of the opening is drawn
/// right after each.
struct NestingFunctions {
  /// For marking: what is visible of the opening raises the stencil buffer from `level` to level + 1. Changes neither
  /// colour nor depth.
  void (*begin_mark)(Gl& gl, int level) = nullptr;
  /// For undoing it: where the stencil buffer holds level + 1 the opening's own depth is written, whatever was there,
  /// and the stencil buffer lowered to `level`. Changes no colour.
  void (*begin_restore)(Gl& gl, int level) = nullptr;
};

class ScenePainter {
 public:
  /// A node with a mesh, where step 01's functions have placed it in the space that shaders call world.
  struct Item {
    int node = 0;  ///< index into Scene::nodes
    glm::mat4 model{1.0f};
    glm::mat3 normal_matrix{1.0f};
    Box3 box;  ///< of the mesh: object space
  };
  virtual ~ScenePainter() = default;

  /// Of the view that is being drawn. A view of another origin (see Viewpoint) makes them anew.
  virtual std::span<const Item> items() const = 0;

  /// Draws items (by their numbers in `items()`) with the pass's program into the framebuffer that is bound; `bind`
  /// sets its uniforms, once. Sets which faces are front faces, a mirrored node's being turned round; culling, depth
  /// test and viewport are the caller's.
  virtual void paint(const PassSources& pass, std::span<const int> items, const std::function<void(Binder&)>& bind) = 0;

  /// Draws a view into a target of the feature's own, as `render` would: a preview, the side of a cube. To be called
  /// from Feature::draw_views.
  virtual void draw_view(const View& view, const Target& target) = 0;

  /// Targets for such views, which a frame lends out and uses again.
  virtual TargetPool& targets() = 0;

  /// Draws a view inside another one, where the item `opening` is seen in it: marks that place in the stencil buffer,
  /// clears it to the background and the farthest depth, draws, and puts back the opening's depth and the mark. The
  /// view's parent and stencil level are set from `around`; its scissor should bound the opening. To be called from
  /// Feature::draw_inside. Throws Error where the target has no stencil buffer, or 255 levels are used up.
  virtual void draw_view_inside(View view, const Viewpoint& around, const Target& target, int opening,
                                const NestingFunctions& functions) = 0;
};

}  // namespace atelier
