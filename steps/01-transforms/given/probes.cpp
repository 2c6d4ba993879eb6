#include "01-transforms/given/probes.hpp"

#include <algorithm>
#include <array>

#include "01-transforms/transforms.hpp"
#include "gl/query.hpp"

namespace atelier {

using namespace transforms;

namespace {

// ---- Conversion to and from numbers

using atelier::numbers_of;

glm::vec3 vec3(const Arguments& in, const std::string& name) {
  return glm::vec3(in.vec3(name));
}
float number(const Arguments& in, const std::string& name) {
  return float(in.number(name));
}

/// The same triangles, each beginning with its smallest index, in ascending order: the contract leaves both free, and only
/// the winding counts. Indices that are no whole triangles stay as they are.
std::vector<std::uint32_t> in_one_order(const std::vector<std::uint32_t>& indices) {
  if (indices.size() % 3 != 0) return indices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    std::array<std::uint32_t, 3> triangle{indices[i], indices[i + 1], indices[i + 2]};
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    triangles.push_back(triangle);
  }
  std::sort(triangles.begin(), triangles.end());
  std::vector<std::uint32_t> ordered;
  for (const auto& triangle : triangles) ordered.insert(ordered.end(), triangle.begin(), triangle.end());
  return ordered;
}

Numbers numbers_of(const Mesh& mesh) {
  Numbers out{double(mesh.vertices.size()), double(mesh.indices.size())};
  for (const Vertex& v : mesh.vertices)
    for (const float x :
         {v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z, v.texcoord.x, v.texcoord.y})
      out.push_back(x);
  append(out, in_one_order(mesh.indices));
  return out;
}

// ---- Probes of more than one line

/// A joint is 17 numbers: its parent and its matrix.
std::vector<Joint> joints(const Arguments& in) {
  const auto& flat = in.numbers("joints");
  std::vector<Joint> out;
  for (std::size_t at = 0; at + 17 <= flat.size(); at += 17) {
    Joint joint{.parent = int(flat[at])};
    for (int i = 0; i < 16; ++i) joint.local[i / 4][i % 4] = float(flat[at + 1 + std::size_t(i)]);
    out.push_back(joint);
  }
  return out;
}

Numbers probe_world_matrices(ProbeContext&, const Arguments& in) {
  Numbers out;
  for (const glm::mat4& m : world_matrices(joints(in))) append(out, numbers_of(m));
  return out;
}

/// The position of the last joint in a chain of `depth` joints, each translated by `step` from its parent, children
/// listed first.
Numbers probe_deep_chain(ProbeContext&, const Arguments& in) {
  const int depth = in.integer("depth");
  std::vector<Joint> chain(std::size_t(depth), Joint{});
  for (int i = 0; i < depth; ++i) {
    chain[std::size_t(i)].parent = i + 1 < depth ? i + 1 : -1;
    chain[std::size_t(i)].local[3] = glm::vec4(vec3(in, "step"), 1);
  }
  return numbers_of(glm::vec3(world_matrices(chain)[0][3]));
}

/// The normal multiplied by the normal matrix, normalised, so that any positive multiple of the matrix is right.
Numbers probe_normal_matrix(ProbeContext&, const Arguments& in) {
  const glm::dvec3 n = glm::dmat3(normal_matrix(glm::mat4(in.mat4("model")))) * in.vec3("normal");
  const double length = glm::length(n);
  return length > 0 ? Numbers{n.x / length, n.y / length, n.z / length} : Numbers{n.x, n.y, n.z};
}

/// The OpenGL state of the buffers: count, whether there is a vertex array, whether none is left bound; for each
/// attribute enabled, size, stride, offset, whether it uses the vertex buffer; the index buffer; sizes in bytes.
Numbers describe(Gl& gl, const MeshBuffers& made, bool indexed) {
  Numbers out{double(made.count), double(made.vertex_array != 0)};
  out.push_back(integer_of(gl, GL_VERTEX_ARRAY_BINDING) == 0);
  gl.BindVertexArray(made.vertex_array);
  for (const GLuint attribute : {attribute_position, attribute_normal, attribute_texcoord}) {
    GLint enabled = 0, size = 0, stride = 0, buffer = 0;
    gl.GetVertexAttribiv(attribute, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &enabled);
    gl.GetVertexAttribiv(attribute, GL_VERTEX_ATTRIB_ARRAY_SIZE, &size);
    gl.GetVertexAttribiv(attribute, GL_VERTEX_ATTRIB_ARRAY_STRIDE, &stride);
    gl.GetVertexAttribiv(attribute, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, &buffer);
    void* offset = nullptr;
    gl.GetVertexAttribPointerv(attribute, GL_VERTEX_ATTRIB_ARRAY_POINTER, &offset);
    // A stride of 0 means tightly packed: report the real distance.
    const int apart = stride ? stride : size * int(sizeof(float));
    if (enabled)
      for (const double x : {1.0, double(size), double(apart), double(reinterpret_cast<std::intptr_t>(offset)),
                             double(made.vertex_buffer != 0 && GLuint(buffer) == made.vertex_buffer)})
        out.push_back(x);
    else
      out.insert(out.end(), 5, 0.0);
  }
  const GLint index_buffer = integer_of(gl, GL_ELEMENT_ARRAY_BUFFER_BINDING);
  out.push_back(indexed ? made.index_buffer != 0 && GLuint(index_buffer) == made.index_buffer : made.index_buffer == 0);
  gl.BindVertexArray(0);
  const auto bytes = [&](GLenum target, GLuint buffer) {
    GLint size = 0;
    gl.BindBuffer(target, buffer);
    if (buffer) gl.GetBufferParameteriv(target, GL_BUFFER_SIZE, &size);
    gl.BindBuffer(target, 0);
    return size;
  };
  out.push_back(bytes(GL_ARRAY_BUFFER, made.vertex_buffer));
  if (indexed) out.push_back(bytes(GL_ELEMENT_ARRAY_BUFFER, made.index_buffer));
  return out;
}

Numbers probe_upload_triangle(ProbeContext& context, const Arguments&) {
  const std::array<glm::vec3, 3> corners = {glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)};
  return describe(context.gl, upload_triangle(context.gl, corners), false);
}

Numbers probe_upload_mesh(ProbeContext& context, const Arguments& in) {
  const std::vector<Vertex> vertices(std::size_t(in.integer("vertices")));
  const std::vector<std::uint32_t> indices(std::size_t(in.integer("indices")), 0);
  return describe(context.gl, upload_mesh(context.gl, vertices, indices), true);
}

Numbers probe_set_wireframe(ProbeContext& context, const Arguments& in) {
  Gl& gl = context.gl;
  const bool on = in.number("on") != 0;
  gl.PolygonMode(GL_FRONT_AND_BACK, GLenum(on ? GL_FILL : GL_LINE));  // so that doing nothing is not right
  set_wireframe(gl, on);
  GLint mode[2] = {0, 0};  // compatibility contexts return two values
  gl.GetIntegerv(GL_POLYGON_MODE, mode);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  return {double(mode[0] == GL_LINE)};
}

}  // namespace

std::map<std::string, Probe> transform_probes() {
  const std::string glsl = text_including("01-transforms/transforms.glsl");
  return {
      {"clip_position", shader_probe(glsl, "clip_position(projection, view, model, position)", 4)},
      {"world_position", shader_probe(glsl, "vec4(world_position(model, position), 1.0)", 3)},
      {"world_normal", shader_probe(glsl, "vec4(world_normal(matrix, normal), 0.0)", 3)},
      {"translation", [](ProbeContext&, const Arguments& in) { return numbers_of(translation(vec3(in, "offset"))); }},
      {"rotation",
       [](ProbeContext&, const Arguments& in) { return numbers_of(rotation(vec3(in, "axis"), number(in, "angle"))); }},
      {"scaling", [](ProbeContext&, const Arguments& in) { return numbers_of(scaling(vec3(in, "factors"))); }},
      {"compose",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(compose(vec3(in, "offset"), vec3(in, "axis"), number(in, "angle"), vec3(in, "factors")));
       }},
      {"world_matrices", probe_world_matrices},
      {"world_matrices_refuses",
       [](ProbeContext&, const Arguments& in) { return refuses([&] { world_matrices(joints(in)); }); }},
      {"deep_chain", probe_deep_chain},
      {"look_at",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(look_at(vec3(in, "eye"), vec3(in, "target"), vec3(in, "up")));
       }},
      {"perspective",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(
             perspective(number(in, "fov_y"), number(in, "aspect"), number(in, "near"), number(in, "far")));
       }},
      {"orthographic_refuses",
       [](ProbeContext&, const Arguments& in) {
         return refuses([&] {
           orthographic(number(in, "left"), number(in, "right"), number(in, "bottom"), number(in, "top"),
                        number(in, "near"), number(in, "far"));
         });
       }},
      {"perspective_refuses",
       [](ProbeContext&, const Arguments& in) {
         return refuses(
             [&] { perspective(number(in, "fov_y"), number(in, "aspect"), number(in, "near"), number(in, "far")); });
       }},
      {"perspective_reversed",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(
             perspective_reversed(number(in, "fov_y"), number(in, "aspect"), number(in, "near"), number(in, "far")));
       }},
      {"orthographic",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(orthographic(number(in, "left"), number(in, "right"), number(in, "bottom"),
                                        number(in, "top"), number(in, "near"), number(in, "far")));
       }},
      {"normal_matrix", probe_normal_matrix},
      {"upload_triangle", probe_upload_triangle},
      {"upload_mesh", probe_upload_mesh},
      {"cylinder_wall",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(cylinder_wall(number(in, "radius"), number(in, "height"), in.integer("segments")));
       }},
      {"cylinder_wall_refuses",
       [](ProbeContext&, const Arguments& in) {
         return refuses([&] { cylinder_wall(number(in, "radius"), number(in, "height"), in.integer("segments")); });
       }},
      {"rectangle",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(rectangle(vec3(in, "centre"), vec3(in, "half_u"), vec3(in, "half_v")));
       }},
      {"set_wireframe", probe_set_wireframe},
      {"window_position",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(window_position(glm::vec4(in.vec4("clip")), glm::vec4(in.vec4("viewport"))));
       }},
      {"relative_to_eye",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(relative_to_eye(in.vec3("position"), in.vec3("eye")));
       }},
  };
}

}  // namespace atelier
