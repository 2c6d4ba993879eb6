#include "demo/texture.hpp"

namespace atelier::demo {

GlTexture upload(Gl& gl, const Image& picture) {
  GlTexture texture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, picture.width(), picture.height(), 0, GL_RGBA, GL_FLOAT, nullptr);
  for (int y = 0; y < picture.height(); ++y)  // OpenGL's first row is the lowest
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, picture.height() - 1 - y, picture.width(), 1, GL_RGBA, GL_FLOAT,
                     &picture.at(0, y));
  gl.GenerateMipmap(GL_TEXTURE_2D);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  return texture;
}

}  // namespace atelier::demo
