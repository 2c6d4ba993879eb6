// Nested views: implements ScenePainter::draw_view_inside and fill_opening.
#include <fmt/core.h>

#include "gl/debug.hpp"
#include "gl/state.hpp"
#include "render/bind_viewpoint.hpp"
#include "render/renderer.hpp"

namespace atelier {

namespace {

/// The stencil test as in the outermost view.
void default_stencil(Gl& gl) {
  gl.Disable(GL_STENCIL_TEST);
  gl.StencilFunc(GL_ALWAYS, 0, 0xff);
}

}  // namespace

/// Draws the surface of an opening in one colour, in the enclosing view. Depths are clamped: an opening nearer than the
/// near plane must not leave a hole while a visitor goes through it.
void Renderer::paint_opening(const Viewpoint& around, int opening, const glm::vec3& colour) {
  PassSources pass{.name = "opening",
                   .vertex =
                       "#ifdef CLIPPED\nuniform vec4 u_openings_clip_plane;\n#endif\n"
                       "void main() {\n"
                       "  gl_Position = clip_position(u_projection, u_view, u_model, a_position);\n"
                       "#ifdef CLIPPED\n"
                       "  gl_ClipDistance[0] =\n"
                       "      dot(u_openings_clip_plane, vec4(world_position(u_model, a_position), 1.0));\n"
                       "#endif\n"
                       "}\n",
                   .fragment = "uniform vec3 u_colour; out vec4 o; void main() { o = vec4(u_colour, 1.0); }\n"};
  const DebugGroup group(gl_, "opening");
  const std::optional<glm::dvec4>& plane = around.view.openings_clip_plane;
  if (plane) {
    pass.structure["CLIPPED"] = "1";
    gl_.Enable(GL_CLIP_DISTANCE0);
  } else {
    gl_.Disable(GL_CLIP_DISTANCE0);
  }
  gl_.Enable(GL_DEPTH_CLAMP);
  paint(pass, std::span(&opening, 1), [&](Binder& binder) {
    bind_viewpoint(binder, around);
    if (plane) binder.set("u_openings_clip_plane", moved_plane(*plane, around.origin));
    binder.set("u_colour", colour);
  });
}

void Renderer::draw_view_inside(View view, const Viewpoint& around, const Target& target, int opening,
                                const NestingFunctions& functions) {
  constexpr int most_levels = 255;
  const int level = around.view.stencil_level;
  if (!has_stencil(target.spec()))
    throw Error(fmt::format("a view inside another needs a stencil buffer, and the target has none ({})",
                            to_string(target.spec())));
  if (level >= most_levels)
    throw Error(fmt::format("views are nested {} deep: an 8-bit stencil buffer allows no more", level));
  if (!functions.begin_mark || !functions.begin_restore)
    throw Error(
        "a view inside another needs the functions of step 07, which this program does not pass to the renderer");
  view.parent = &around.view;
  view.stencil_level = level + 1;

  const DebugGroup group(gl_, fmt::format("view inside, level {}", view.stencil_level));
  set_bounds(around, target);
  default_stencil(gl_);  // whoever marks must say what is compared
  functions.begin_mark(gl_, level);
  paint_opening(around, opening, glm::vec3(0));

  // Clear the marked pixels to the farthest depth and the background.
  set_bounds(around, target);
  gl_.Enable(GL_STENCIL_TEST);
  gl_.StencilFunc(GL_EQUAL, level + 1, 0xff);
  gl_.DepthFunc(GL_ALWAYS);
  const double farthest = view.reversed_depth ? 0.0 : 1.0;
  gl_.DepthRange(farthest, farthest);
  paint_opening(around, opening, background(view));

  draw_scene(view, target);

  // A view with another origin has recomputed the nodes' matrices.
  counts_.matrices += nodes_->place(around.view.camera_relative, around.origin);
  set_bounds(around, target);
  default_stencil(gl_);
  functions.begin_restore(gl_, level);
  paint_opening(around, opening, glm::vec3(0));
  set_bounds(around, target);
}

void Renderer::fill_opening(const Viewpoint& around, const Target& target, int opening, const glm::vec3& colour) {
  set_bounds(around, target);
  paint_opening(around, opening, colour);
  set_bounds(around, target);
}

}  // namespace atelier
