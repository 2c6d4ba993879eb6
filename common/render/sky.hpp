// The sky of a scene, drawn behind all surfaces of a view.
#pragma once

#include "gl/objects.hpp"
#include "render/programs.hpp"
#include "render/view.hpp"

namespace atelier {

class Skybox {
 public:
  /// Uploads the faces to a cube map of 32-bit floats, and binds it to the last texture unit of the context. Features
  /// count units from 0, so nothing else uses the last one: the cube map stays bound for all frames. If a context has
  /// several skyboxes, all draw the one that was made last. Throws Error if this driver has no faces as large.
  Skybox(Gl& gl, const Sky& sky);

  /// The program that draws it.
  static const PassSources& pass();

  /// Shades the pixels of a view that no surface covers: those with the farthest depth, in the view's scissor and
  /// stencil level. Call it after the view's surfaces are drawn, in the same state. Writes no depth, and is not cut by
  /// the view's clip plane. Changes depth function, mask and range, culling, clip distances and the polygon mode, which
  /// reset_state restores.
  void draw(const Viewpoint& viewpoint, Program& program) const;

 private:
  Gl& gl_;
  int unit_;  ///< of the cube map
  GlTexture cube_;
  GlVertexArray no_attributes_;  ///< a core context draws nothing without a vertex array
};

}  // namespace atelier
