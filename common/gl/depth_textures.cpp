#include "gl/depth_textures.hpp"

#include <fmt/core.h>

#include <glm/glm.hpp>

#include "base/error.hpp"
#include "gl/query.hpp"

namespace atelier {

namespace {

GLenum face_of(int face) {
  return GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face);
}

/// How the bound texture is read.
void set_reading(Gl& gl, GLenum kind, GLint wrap, bool compare) {
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(kind, name, compare ? GL_LINEAR : GL_NEAREST);
  for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.TexParameteri(kind, name, wrap);
  gl.TexParameteri(kind, GL_TEXTURE_COMPARE_MODE, compare ? GL_COMPARE_REF_TO_TEXTURE : GL_NONE);
  gl.TexParameteri(kind, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

}  // namespace

GlTexture make_depth_layers(Gl& gl, int edge, std::span<const float> depths, bool compare) {
  const std::size_t texels = std::size_t(edge) * std::size_t(edge);
  if (edge < 1 || depths.empty() || depths.size() % texels != 0)
    throw Error(fmt::format("{} depths are no whole number of layers of {} x {} texels", depths.size(), edge, edge));
  GlTexture texture(gl);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, texture.id());
  gl.TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, edge, edge, GLsizei(depths.size() / texels), 0,
                GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  set_reading(gl, GL_TEXTURE_2D_ARRAY, GL_CLAMP_TO_BORDER, compare);
  const glm::vec4 farthest(1);
  gl.TexParameterfv(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BORDER_COLOR, &farthest[0]);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, 0);
  return texture;
}

GlTexture make_depth_cube(Gl& gl, int edge, std::span<const float> depths, bool compare) {
  GlTexture cube(gl);
  fill_depth_cube(gl, cube.id(), GL_DEPTH_COMPONENT32F, edge, depths);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, cube.id());
  set_reading(gl, GL_TEXTURE_CUBE_MAP, GL_CLAMP_TO_EDGE, compare);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, 0);
  return cube;
}

void fill_depth_cube(Gl& gl, GLuint cube, GLenum format, int edge, std::span<const float> depths) {
  const std::size_t texels = std::size_t(edge) * std::size_t(edge);
  if (edge < 1 || depths.size() != 6 * texels)
    throw Error(fmt::format("{} depths are not those of six faces of {} x {} texels", depths.size(), edge, edge));
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, cube);
  for (int face = 0; face < 6; ++face)
    gl.TexImage2D(face_of(face), 0, GLint(format), edge, edge, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                  &depths[std::size_t(face) * texels]);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, 0);
}

std::vector<float> even_faces(int edge, const std::array<float, 6>& depths) {
  std::vector<float> faces;
  for (const float depth : depths) faces.insert(faces.end(), std::size_t(edge) * std::size_t(edge), depth);
  return faces;
}

std::vector<float> read_depth_layers(Gl& gl, GLuint layers) {
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, layers);
  const std::vector<GLint> size =
      level_parameters(gl, GL_TEXTURE_2D_ARRAY, {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH});
  const std::size_t texels = std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]);
  std::vector<float> depths(texels);
  gl.GetTexImage(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, 0);
  return depths;
}

std::vector<float> read_depth_cube(Gl& gl, GLuint cube) {
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, cube);
  const std::vector<GLint> size = level_parameters(gl, face_of(0), {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT});
  const std::size_t texels = std::size_t(size[0]) * std::size_t(size[1]);
  std::vector<float> depths(6 * texels);
  for (int face = 0; face < 6; ++face)
    gl.GetTexImage(face_of(face), 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data() + std::size_t(face) * texels);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, 0);
  return depths;
}

GlFramebuffer make_depth_framebuffer(Gl& gl) {
  GlFramebuffer framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  return framebuffer;
}

}  // namespace atelier
