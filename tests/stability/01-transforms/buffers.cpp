// upload_triangle, upload_mesh, set_wireframe: empty and large meshes, values that are no numbers, states set twice.
#include <cstring>

#include "stability/01-transforms/rows.hpp"

namespace atelier::stability {

namespace {

/// Takes over the objects, so that a row leaves nothing behind.
struct OwnedMesh {
  OwnedMesh(Gl& gl, const MeshBuffers& made)
      : vertex_array(gl, made.vertex_array),
        vertex_buffer(gl, made.vertex_buffer),
        index_buffer(gl, made.index_buffer),
        count(made.count) {}
  GlVertexArray vertex_array;
  GlBuffer vertex_buffer, index_buffer;
  GLsizei count;
};

double size_of(Gl& gl, const GlBuffer& buffer) {
  GLint bytes = 0;
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer.id());
  gl.GetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &bytes);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  return bytes;
}

double bound_vertex_array(Gl& gl) {
  GLint bound = 0;
  gl.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
  return bound;
}

/// Count, bytes of vertices and of indices, what is bound afterwards, and OpenGL's error.
Values after_upload(Gl& gl, std::size_t vertices, std::size_t indices, float value = 0) {
  const std::vector<Vertex> corners(vertices, Vertex{glm::vec3(value), glm::vec3(value), glm::vec2(value)});
  const std::vector<std::uint32_t> order(indices, 0);
  const OwnedMesh mesh(gl, transforms::upload_mesh(gl, corners, order));
  return {double(mesh.count), size_of(gl, mesh.vertex_buffer), size_of(gl, mesh.index_buffer), bound_vertex_array(gl),
          double(gl.GetError())};
}

Values after_triangle(Gl& gl, float value) {
  const std::array<glm::vec3, 3> corners = {glm::vec3(value), glm::vec3(value), glm::vec3(value)};
  const OwnedMesh mesh(gl, transforms::upload_triangle(gl, corners));
  return {double(mesh.count), size_of(gl, mesh.vertex_buffer), double(mesh.index_buffer.id()), bound_vertex_array(gl),
          double(gl.GetError())};
}

bool wireframe_is_on(Gl& gl) {
  GLint mode[2] = {0, 0};  // compatibility contexts answer with two values
  gl.GetIntegerv(GL_POLYGON_MODE, mode);
  return mode[0] == GL_LINE;
}

}  // namespace

void add_buffer_rows(Table& table, ShaderFunctions& shaders) {
  Gl& gl = shaders.gl();
  Group triangle = table.of("upload_triangle");
  for (const float value : {0.0f, not_a_number, infinite, largest_float})
    triangle.equals(fmt::format("three corners at {:g}", value), [&gl, value] { return after_triangle(gl, value); },
                    {3, 36, 0, 0, 0});

  Group mesh = table.of("upload_mesh");
  const double vertex = sizeof(Vertex);
  mesh.equals("no vertices, no indices", [&gl] { return after_upload(gl, 0, 0); }, {0, 0, 0, 0, 0});
  mesh.equals("vertices without indices", [&gl] { return after_upload(gl, 3, 0); }, {0, 3 * vertex, 0, 0, 0});
  mesh.equals("70 000 vertices: more than 16 bits can count", [&gl] { return after_upload(gl, 70'000, 300'000); },
              {300'000, 70'000 * vertex, 1'200'000, 0, 0});
  mesh.equals("vertices of NaN", [&gl] { return after_upload(gl, 3, 3, not_a_number); }, {3, 3 * vertex, 12, 0, 0});

  Group wireframe = table.of("set_wireframe");
  wireframe.equals("on, on, off, off, on",
                   [&gl] {
                     Values seen;
                     for (const bool on : {true, true, false, false, true}) {
                       transforms::set_wireframe(gl, on);
                       seen.push_back(wireframe_is_on(gl));
                     }
                     gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
                     seen.push_back(gl.GetError());
                     return seen;
                   },
                   {1, 1, 0, 0, 1, 0});
}

}  // namespace atelier::stability
