// A scene in OpenGL's memory as a first demo holds it: every triangle with corners of its own, one texture for all.
#pragma once

#include <vector>

#include "gl/objects.hpp"
#include "gl/shader.hpp"
#include "scene/scene.hpp"

namespace atelier::shadow_demo {

class DemoScene {
 public:
  /// Uploads the meshes, without indices, and the first material's texture with mipmaps: as 32-bit floats, or with
  /// `compact_texture` as sRGB codes of 8 bits.
  DemoScene(Gl& gl, Scene scene, bool compact_texture);

  const Scene& scene() const { return scene_; }
  const Material& material() const { return scene_.materials.front(); }
  GLuint texture() const { return texture_.id(); }

  /// Draws all nodes in their order with the program in use, each with its own `u_model`.
  void draw(Gl& gl, Uniforms& uniforms) const;

 private:
  struct Drawn {
    GlVertexArray vertex_array;
    GlBuffer corners;
    GLsizei count = 0;
  };
  Scene scene_;
  std::vector<Drawn> meshes_;
  std::vector<glm::mat4> models_;  ///< node by node
  GlTexture texture_;
};

}  // namespace atelier::shadow_demo
