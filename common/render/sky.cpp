#include "render/sky.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "gl/debug.hpp"
#include "gl/full_screen.hpp"
#include "gl/query.hpp"

namespace atelier {

namespace {

/// From (u, v, 1), where u and v are 0..1 across the target, to the direction in world space, of any length, that is
/// visible there.
///
/// Let (x, y) = (2u - 1, 2v - 1) be normalised device coordinates and r_x, r_y, r_w the first three entries of the
/// projection's rows. A direction d of view space is at (x, y) if r_x.d = x r_w.d and r_y.d = y r_w.d, so d is the
/// cross product of r_y - y r_w and r_x - x r_w; in this order it points ahead, where no projection mirrors. The row of
/// z, which is different with an oblique near plane, is not used. An orthographic projection has r_w = 0: one
/// direction.
glm::mat3 direction_of_texcoord(const Viewpoint& viewpoint) {
  const glm::mat4& p = viewpoint.projection;
  const auto row = [&](int i) { return glm::dvec3(p[0][i], p[1][i], p[2][i]); };
  const glm::dvec3 x = row(0), y = row(1), w = row(3);
  const glm::dmat3 from_ndc(glm::cross(w, y), glm::cross(x, w), glm::cross(y, x)), to_ndc(2, 0, 0, 0, 2, 0, -1, -1, 1);
  const glm::dmat3 to_world = glm::transpose(glm::dmat3(viewpoint.world_to_view));  // the inverse: rotates or mirrors
  return glm::mat3(to_world * from_ndc * to_ndc);
}

GlTexture upload(Gl& gl, const Sky& sky, int unit) {
  const int edge = sky.faces[0].width(), longest = integer_of(gl, GL_MAX_CUBE_MAP_TEXTURE_SIZE);
  if (edge > longest) throw Error(fmt::format("a sky of {} texels a side: this driver has 1..{}", edge, longest));
  GlTexture cube(gl);
  gl.ActiveTexture(GLenum(GL_TEXTURE0 + unit));
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, cube.id());
  for (int face = 0; face < 6; ++face)
    gl.TexImage2D(GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), 0, GL_RGBA32F, edge, edge, 0, GL_RGBA, GL_FLOAT,
                  sky.faces[std::size_t(face)].pixels().data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_CUBE_MAP, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.TexParameteri(GL_TEXTURE_CUBE_MAP, wrap, GL_CLAMP_TO_EDGE);
  gl.ActiveTexture(GL_TEXTURE0);
  label(gl, GL_TEXTURE, cube.id(), "sky");
  check_gl_error(gl, "making the sky");
  return cube;
}

}  // namespace

Skybox::Skybox(Gl& gl, const Sky& sky)
    : gl_(gl),
      unit_(integer_of(gl, GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS) - 1),
      cube_(upload(gl, sky, unit_)),
      no_attributes_(gl) {}

const PassSources& Skybox::pass() {
  static const PassSources sources{.name = "sky",
                                   .vertex = full_screen_vertex_text,
                                   .fragment =
                                       "in vec2 v_texcoord;\n"
                                       "out vec4 o_colour;\n"
                                       "uniform mat3 u_direction_of_texcoord;\n"
                                       "uniform samplerCube u_sky;\n"
                                       "void main() {\n"
                                       "  vec3 direction_world = u_direction_of_texcoord * vec3(v_texcoord, 1.0);\n"
                                       "  o_colour = vec4(texture(u_sky, direction_world).rgb, 1.0);\n"
                                       "}\n"};
  return sources;
}

void Skybox::draw(const Viewpoint& viewpoint, Program& program) const {
  const DebugGroup group(gl_, "sky");
  gl_.UseProgram(program.program.id());
  program.uniforms.set("u_sky", unit_);
  program.uniforms.set("u_direction_of_texcoord", direction_of_texcoord(viewpoint));
  gl_.Disable(GL_CULL_FACE);
  for (const GLenum distance : {GL_CLIP_DISTANCE0, GL_CLIP_DISTANCE1}) gl_.Disable(distance);  // of views and of nodes
  gl_.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  // As deep as the cleared depth: a pixel that is covered fails the test before it is shaded.
  const bool reversed = viewpoint.view.reversed_depth;
  const double farthest = reversed ? 0 : 1;
  gl_.DepthRange(farthest, farthest);
  gl_.DepthFunc(GLenum(reversed ? GL_GEQUAL : GL_LEQUAL));
  gl_.DepthMask(GL_FALSE);
  // Whether other cube maps are seamless is for those to say who make them.
  const bool seamless = gl_.IsEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  gl_.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  gl_.BindVertexArray(no_attributes_.id());
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  gl_.BindVertexArray(0);
  if (!seamless) gl_.Disable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

}  // namespace atelier
