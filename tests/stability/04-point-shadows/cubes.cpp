// make_cube_map, begin_cube_pass: one texel a face, odd sizes, every format, each face alone.
#include "gl/depth_textures.hpp"
#include "stability/04-point-shadows/rows.hpp"

namespace atelier::stability {

using point_shadows::begin_cube_pass;
using point_shadows::make_cube_map;

namespace {

/// Whether the framebuffer is complete, the edge of face -z, what is bound as a cube afterwards, and OpenGL's error.
Values after_making(Gl& gl, int resolution, GLenum format, bool compare) {
  const OwnedCube cube(gl, make_cube_map(gl, resolution, format, compare));
  GLint bound = 0, edge = 0;
  gl.GetIntegerv(GL_TEXTURE_BINDING_CUBE_MAP, &bound);
  gl.BindFramebuffer(GL_FRAMEBUFFER, cube.framebuffer.id());
  const bool complete = gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, cube.texture.id());
  gl.GetTexLevelParameteriv(GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, 0, GL_TEXTURE_WIDTH, &edge);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, 0);
  return {double(complete), double(edge), double(bound), double(gl.GetError())};
}

/// How many texels of each face are 1 after a cube full of 0 was made ready for drawing `face`.
Values texels_cleared(Gl& gl, int resolution, int face) {
  const OwnedCube cube = filled_cube(gl, resolution, GL_DEPTH_COMPONENT32F, false, {});
  begin_cube_pass(gl, cube.names, face, false);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.Disable(GL_DEPTH_CLAMP);
  gl.Disable(GL_DEPTH_TEST);
  const std::vector<float> texels = read_depth_cube(gl, cube.texture.id());
  Values counts(6, 0);
  for (std::size_t i = 0; i < texels.size(); ++i) counts[i / (texels.size() / 6)] += texels[i] == 1;
  return counts;
}

}  // namespace

void add_cube_rows(Table& table, ShaderFunctions& shaders) {
  Gl& gl = shaders.gl();
  Group make = table.of("make_cube_map");
  struct Format {
    const char* words;
    GLenum format;
  };
  for (const Format& f : {Format{"16 bits", GL_DEPTH_COMPONENT16},
                          {"24 bits", GL_DEPTH_COMPONENT24},
                          {"32-bit floats", GL_DEPTH_COMPONENT32F}})
    for (const int resolution : {1, 3, 100})
      make.equals(fmt::format("{0}x{0}, {1}: complete with all six faces, nothing left bound", resolution, f.words),
                  [&gl, f, resolution] { return after_making(gl, resolution, f.format, resolution == 3); },
                  {1, double(resolution), 0, 0});

  Group begin = table.of("begin_cube_pass");
  for (const int resolution : {1, 3, 100}) {
    const double all = resolution * resolution;
    begin.equals(
        fmt::format("all six faces of {0}x{0}: each texel cleared", resolution),
        [&gl, resolution] { return texels_cleared(gl, resolution, -1); }, Values(6, all));
    begin.equals(fmt::format("face +x alone, {0}x{0}", resolution),
                 [&gl, resolution] { return texels_cleared(gl, resolution, 0); }, {all, 0, 0, 0, 0, 0});
    begin.equals(fmt::format("face -z alone, {0}x{0}", resolution),
                 [&gl, resolution] { return texels_cleared(gl, resolution, 5); }, {0, 0, 0, 0, 0, all});
  }
}

}  // namespace atelier::stability
