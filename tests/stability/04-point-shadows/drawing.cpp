// draw_in_faces, stored_distance: a shell around the lamp, drawn by the step's own functions into all faces at once and
// read back texel by texel: no hole at an edge, at no size, far from the origin, and with things that touch the lamp.
#include "gl/depth_textures.hpp"
#include "scene/shapes.hpp"
#include "stability/04-point-shadows/rows.hpp"

namespace atelier::stability {

using namespace point_shadows;

namespace {

constexpr const char* corners_as_they_are =
    "layout(location = 0) in vec3 a_position;\nout vec3 v_corner_world;\n"
    "void main() { v_corner_world = a_position; }\n";
constexpr const char* spread =
    "#define GEOMETRY\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 18) out;\n"
    "in vec3 v_corner_world[];\nout vec3 g_position_world;\n"
    "uniform mat4 u_face_matrices[6];\nuniform float u_face_wanted[6];\n"
    "#include \"04-point-shadows/cube_pass.glsl\"\nvoid main() { draw_in_faces(); }\n";
constexpr const char* distances =
    "#define FRAGMENT\nuniform vec3 u_light_position;\nuniform float u_far;\nin vec3 g_position_world;\n"
    "#include \"04-point-shadows/cube_pass.glsl\"\n"
    "void main() { gl_FragDepth = stored_distance(g_position_world, u_light_position, u_far); }\n";

/// What is drawn: triangles in world space, around which lamp, into which faces.
struct Drawing {
  std::vector<glm::vec3> corners;
  glm::vec3 lamp{0};
  float near = 0.01f, far = 10;
  int resolution = 16;
  std::array<bool, 6> wanted{true, true, true, true, true, true};
};

/// The corners, three a triangle, of a ball around the lamp: 320 flat triangles.
std::vector<glm::vec3> shell(const glm::vec3& lamp, float radius) {
  const Mesh ball = make_icosphere({.radius = 1, .subdivisions = 2});
  std::vector<glm::vec3> corners;
  for (const std::uint32_t index : ball.indices) corners.push_back(lamp + radius * ball.vertices[index].position);
  return corners;
}

/// All texels that the drawing leaves, face by face.
Values drawn(ShaderFunctions& shaders, const Drawing& drawing) {
  Gl& gl = shaders.gl();
  const OwnedCube cube(gl, make_cube_map(gl, drawing.resolution, GL_DEPTH_COMPONENT32F, false));
  const GLuint program = shaders.pipeline(corners_as_they_are, spread, distances);
  const GlVertexArray array(gl);
  const GlBuffer buffer(gl);
  gl.BindVertexArray(array.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer.id());
  gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(drawing.corners.size() * sizeof(glm::vec3)), drawing.corners.data(),
                GL_STATIC_DRAW);
  gl.EnableVertexAttribArray(0);
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl.UseProgram(program);
  Uniforms uniforms(gl, program);
  uniforms.set("u_light_position", drawing.lamp);
  uniforms.set("u_far", drawing.far);
  for (int face = 0; face < 6; ++face) {
    uniforms.set(fmt::format("u_face_matrices[{}]", face),
                 face_projection(drawing.near, drawing.far) * face_view(drawing.lamp, face));
    uniforms.set(fmt::format("u_face_wanted[{}]", face), drawing.wanted[std::size_t(face)] ? 1.0f : 0.0f);
  }
  begin_cube_pass(gl, cube.names, -1, false);
  gl.DrawArrays(GL_TRIANGLES, 0, GLsizei(drawing.corners.size()));
  gl.BindVertexArray(0);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.Disable(GL_DEPTH_CLAMP);
  gl.Disable(GL_DEPTH_TEST);
  check_gl_error(gl, "drawing into a cube");

  const std::vector<float> texels = read_depth_cube(gl, cube.texture.id());
  return Values(texels.begin(), texels.end());
}

/// How many texels are not between two distances, metres.
double texels_outside(Values texels, double low, double high, float far) {
  for (double& texel : texels) texel *= double(far);
  return count_outside(texels, low, high);
}

}  // namespace

void add_drawing_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("draw_in_faces, stored_distance (GLSL)");
  // The middles of the flat triangles lie 1.9 % within the ball.
  const auto holes = [&shaders](float radius, float near, float far, int resolution, const glm::vec3& lamp) {
    const Values texels = drawn(shaders, {shell(lamp, radius), lamp, near, far, resolution});
    return texels_outside(texels, 0.975 * double(radius), 1.001 * double(radius), far);
  };
  for (const int resolution : {1, 2, 7, 64, 100})
    group.equals(fmt::format("a shell of 3 m around the lamp, {0}x{0}: texels off it", resolution),
                 [=] {
                   return Values{holes(3, 0.01f, 10, resolution, {0, 0, 0})};
                 },
                 {0});
  group.equals("shells of 0.1 m and 9e5 m between 1e-3 m and 1e6 m",
               [=] {
                 return Values{holes(0.1f, 1e-3f, 1e6f, 32, {0, 0, 0}), holes(9e5f, 1e-3f, 1e6f, 32, {0, 0, 0})};
               },
               {0, 0});
  group.equals("a shell nearer than the near plane: pressed onto it, and its distance is kept",
               [=] {
                 return Values{holes(0.1f, 1, 10, 32, {0, 0, 0})};
               },
               {0});
  group.equals("a shell of 50 m around a lamp 1e4 m from the origin",
               [=] {
                 return Values{holes(50, 1e-2f, 100, 32, {1e4f, -1e4f, 1e4f})};
               },
               {0});
  for (const int face : {0, 3, 5})
    group.equals(
        fmt::format("face {} alone is wanted: texels that are drawn", face),
        [=, &shaders] {
          Drawing one{shell({0, 0, 0}, 3)};
          one.wanted.fill(false);
          one.wanted[std::size_t(face)] = true;
          const Values texels = drawn(shaders, one);
          Values counts(6, 0);
          for (std::size_t i = 0; i < texels.size(); ++i) counts[i / 256] += texels[i] < 1;
          return counts;
        },
        [face] {
          Values counts(6, 0);
          counts[std::size_t(face)] = 256;
          return counts;
        }());
  group.equals("no triangle: all at the farthest",
               [&shaders] { return Values{texels_outside(drawn(shaders, {}), 10, 10, 10)}; }, {0});
  group.equals("a triangle through the lamp, one with a corner at it, one without an area: texels outside 0..far",
               [&shaders] {
                 const Values texels = drawn(shaders, {{{-5, 0, -5},
                                                        {5, 0, -5},
                                                        {0, 0, 7},  //
                                                        {0, 0, 0},
                                                        {2, 3, 1},
                                                        {2, -3, 1},  //
                                                        {1, 1, 1},
                                                        {2, 2, 2},
                                                        {3, 3, 3}}});
                 return Values{texels_outside(texels, 0, 10, 10)};
               },
               {0});

  Group stored = table.of("stored_distance (GLSL)");
  const ShaderFunction function{text_including("04-point-shadows/cube_pass.glsl", {{"FRAGMENT", ""}}),
                                {"position", "light", "far"},
                                "vec4(stored_distance(position.xyz, light.xyz, far.x))"};
  const auto distance = [&shaders, function](const glm::vec3& position, const glm::vec3& light, float far) {
    return shaders.number(function, input_of(position, light, far));
  };
  stored.equals("at the lamp; beyond the farthest, also by 1e18",
                [=] {
                  return Values{distance({1, 2, 3}, {1, 2, 3}, 5), distance({0, 9, 0}, {0, 0, 0}, 5),
                                distance({1e18f, 0, 0}, {0, 0, 0}, 5)};
                },
                {0, 1, 1});
  stored.close("1000 random ways of 1e-6 to 1e6 m: the same share by all of them",
               {6 * rounding_unit, "absolute", "three squares, two sums, a root and a quotient, halved by the root"},
               [=, &shaders] {
                 std::vector<ShaderInput> inputs;
                 Values expected;
                 for (int i = 0; i < 1000; ++i) {
                   Trial t(420, i);
                   const double far = t.size_between(1e-6, 1e6);
                   const glm::vec3 position(far * t.between(0, 1) * t.direction());
                   inputs.push_back(input_of(position, glm::vec3(0), float(far)));
                   expected.push_back(std::min(1.0, glm::length(glm::dvec3(position)) / double(float(far))));
                 }
                 return difference(shaders.numbers(function, inputs), expected);
               });
}

}  // namespace atelier::stability
