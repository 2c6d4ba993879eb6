#include "gl/cube_target.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.hpp"
#include "gl/debug.hpp"
#include "gl/query.hpp"

namespace atelier {

CubeTarget::CubeTarget(Gl& gl, const CubeTargetSpec& spec) : spec_(spec), texture_(gl) {
  const int longest = std::min(longest_side(gl, spec.samples), integer_of(gl, GL_MAX_CUBE_MAP_TEXTURE_SIZE));
  if (spec.colour == ColourFormat::none) throw Error("a cube target needs a colour");
  if (spec.edge < 1 || spec.edge > longest)
    throw Error(fmt::format("a cube of {} pixels a side: this driver has 1..{}", spec.edge, longest));
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, texture_.id());
  for (int side = 0; side < 6; ++side)
    gl.TexImage2D(GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + side), 0, GLint(internal_format(spec.colour)), spec.edge,
                  spec.edge, 0, GL_RGBA, GL_FLOAT, nullptr);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_CUBE_MAP, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.TexParameteri(GL_TEXTURE_CUBE_MAP, wrap, GL_CLAMP_TO_EDGE);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, 0);
  check_gl_error(gl, "making a cube target");
  for (int side = 0; side < 6; ++side)
    faces_.emplace_back(gl,
                        TargetSpec{.width = spec.edge,
                                   .height = spec.edge,
                                   .colour = spec.colour,
                                   .depth = spec.depth,
                                   .samples = spec.samples},
                        Target::CubeFace{texture_.id(), side});
  label(gl, GL_TEXTURE, texture_.id(), "cube target");
}

}  // namespace atelier
