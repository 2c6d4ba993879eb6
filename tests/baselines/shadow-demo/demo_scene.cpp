#include "shadow-demo/demo_scene.hpp"

#include <cstddef>

#include "demo/texture.hpp"
#include "gl/compact_texture.hpp"

namespace atelier::shadow_demo {

namespace {

std::vector<Vertex> written_out(const Mesh& mesh) {
  std::vector<Vertex> corners;
  for (const std::uint32_t index : mesh.indices) corners.push_back(mesh.vertices[index]);
  return corners;
}

}  // namespace

DemoScene::DemoScene(Gl& gl, Scene scene, bool compact_texture) : scene_(std::move(scene)) {
  for (const Mesh& mesh : scene_.meshes) {
    const std::vector<Vertex> corners = written_out(mesh);
    meshes_.push_back({GlVertexArray(gl), GlBuffer(gl), GLsizei(corners.size())});
    const Drawn& drawn = meshes_.back();
    gl.BindVertexArray(drawn.vertex_array.id());
    gl.BindBuffer(GL_ARRAY_BUFFER, drawn.corners.id());
    gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(corners.size() * sizeof(Vertex)), corners.data(), GL_STATIC_DRAW);
    const auto attribute = [&](GLuint location, GLint numbers, std::size_t offset) {
      gl.EnableVertexAttribArray(location);
      gl.VertexAttribPointer(location, numbers, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                             reinterpret_cast<const void*>(offset));
    };
    attribute(0, 3, offsetof(Vertex, position));
    attribute(1, 3, offsetof(Vertex, normal));
    attribute(2, 2, offsetof(Vertex, texcoord));
  }
  gl.BindVertexArray(0);
  for (const glm::dmat4& model : world_matrices_exact(scene_.nodes)) models_.emplace_back(model);
  texture_ = demo::upload(gl, scene_.textures.at(std::size_t(material().diffuse_texture.value())).pixels);
  if (compact_texture) store_in_8_bits(gl, texture_.id(), Encoding::linear);
}

void DemoScene::draw(Gl& gl, Uniforms& uniforms) const {
  for (std::size_t node = 0; node < scene_.nodes.size(); ++node) {
    const Drawn& mesh = meshes_[std::size_t(scene_.nodes[node].mesh.value())];
    uniforms.set("u_model", models_[node]);
    gl.BindVertexArray(mesh.vertex_array.id());
    gl.DrawArrays(GL_TRIANGLES, 0, mesh.count);
  }
  gl.BindVertexArray(0);
}

}  // namespace atelier::shadow_demo
