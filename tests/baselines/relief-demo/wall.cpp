#include "relief-demo/wall.hpp"

#include <cstddef>
#include <glm/gtc/matrix_transform.hpp>

#include "demo/texture.hpp"
#include "gl/compact_texture.hpp"
#include "relief-demo/shaders.hpp"

namespace atelier::relief_demo {

namespace {

struct Corner {
  Vertex vertex;
  glm::vec3 tangent;
};

/// Every triangle with corners and a tangent of its own.
std::vector<Corner> written_out(const Mesh& mesh) {
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vertex& a = mesh.vertices[mesh.indices[i]];
    const Vertex& b = mesh.vertices[mesh.indices[i + 1]];
    const Vertex& c = mesh.vertices[mesh.indices[i + 2]];
    const glm::vec2 ab = b.texcoord - a.texcoord, ac = c.texcoord - a.texcoord;
    const float f = 1 / (ab.x * ac.y - ac.x * ab.y);
    const glm::vec3 tangent = f * (ac.y * (b.position - a.position) - ab.y * (c.position - a.position));
    for (const Vertex& corner : {a, b, c}) corners.push_back({corner, tangent});
  }
  return corners;
}

const Image& pixels_of(const Scene& scene, const TextureIndex& texture) {
  return scene.textures.at(std::size_t(texture.value())).pixels;
}

Image depths_of(const Image& heights) {
  Image depths = heights;
  for (Rgba& texel : depths.pixels()) texel = {1 - texel.r, 1 - texel.g, 1 - texel.b, 1};
  return depths;
}

GlTexture upload(Gl& gl, const Image& picture, bool compact, Encoding encoding) {
  GlTexture texture = demo::upload(gl, picture);
  if (compact) store_in_8_bits(gl, texture.id(), encoding);
  return texture;
}

}  // namespace

Wall::Wall(Gl& gl, Scene scene, double depth, MapFormats formats)
    : gl_(gl),
      scene_(std::move(scene)),
      depth_(float(depth)),
      vertex_array_(gl),
      corners_(gl),
      colours_(upload(gl, pixels_of(scene_, scene_.materials.front().diffuse_texture), formats.compact_colours,
                      Encoding::linear)),
      normals_(
          upload(gl, pixels_of(scene_, scene_.materials.front().normal_texture), formats.compact_maps, Encoding::data)),
      depths_(upload(gl, depths_of(pixels_of(scene_, scene_.materials.front().height_texture)), formats.compact_maps,
                     Encoding::data)) {
  const std::vector<Corner> corners = written_out(scene_.meshes.front());
  count_ = GLsizei(corners.size());
  gl.BindVertexArray(vertex_array_.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, corners_.id());
  gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(corners.size() * sizeof(Corner)), corners.data(), GL_STATIC_DRAW);
  const auto attribute = [&](GLuint location, GLint numbers, std::size_t offset) {
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(location, numbers, GL_FLOAT, GL_FALSE, sizeof(Corner),
                           reinterpret_cast<const void*>(offset));
  };
  attribute(0, 3, offsetof(Vertex, position));
  attribute(1, 3, offsetof(Vertex, normal));
  attribute(2, 2, offsetof(Vertex, texcoord));
  attribute(3, 3, offsetof(Corner, tangent));
  gl.BindVertexArray(0);
}

demo::Program& Wall::program(const std::string& output) {
  if (!programs_.contains(output))
    programs_.emplace(output, demo::build(gl_, "relief-demo", wall_vertex(), wall_fragment(depth_ > 0, output)));
  return programs_.at(output);
}

void Wall::set_uniforms(Uniforms& uniforms, const Frame& frame) const {
  const Camera& camera = frame.camera;
  const TargetSpec& size = frame.target.spec();
  const Material& material = scene_.materials.front();
  const Light& lamp = scene_.lights.front();
  const glm::vec3 eye(camera.eye);
  uniforms.set("u_model", glm::mat4(world_matrices_exact(scene_.nodes).front()));
  uniforms.set("u_view", glm::lookAt(eye, glm::vec3(camera.target), camera.up));
  uniforms.set("u_projection",
               glm::perspective(camera.fov_y, float(size.width) / float(size.height), camera.near, camera.far));
  uniforms.set("u_eye", eye);
  uniforms.set("u_lamp", glm::vec3(lamp.position));
  uniforms.set("u_light_colour", lamp.colour);
  uniforms.set("u_attenuation", lamp.attenuation);
  uniforms.set("u_ambient", scene_.ambient);
  uniforms.set("u_diffuse", material.diffuse);
  uniforms.set("u_specular", material.specular);
  uniforms.set("u_exponent", material.exponent);
  uniforms.set("u_depth", depth_);
  uniforms.set("u_colours", 0);
  uniforms.set("u_normals", 1);
  uniforms.set("u_depths", 2);
}

void Wall::draw(const Frame& frame) {
  frame.target.bind(gl_);
  const glm::vec3 background = frame.output == "colour" ? scene_.background : glm::vec3(0);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_LESS);
  gl_.ClearColor(background.r, background.g, background.b, 1);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  demo::Program& used = program(frame.output);
  gl_.UseProgram(used.program.id());
  set_uniforms(used.uniforms, frame);
  GLenum unit = GL_TEXTURE0;
  for (const GlTexture* map : {&colours_, &normals_, &depths_}) {
    gl_.ActiveTexture(unit++);
    gl_.BindTexture(GL_TEXTURE_2D, map->id());
  }
  gl_.BindVertexArray(vertex_array_.id());
  gl_.DrawArrays(GL_TRIANGLES, 0, count_);
  gl_.BindVertexArray(0);
  gl_.ActiveTexture(GL_TEXTURE0);
  check_gl_error(gl_, "drawing the demo");
}

}  // namespace atelier::relief_demo
