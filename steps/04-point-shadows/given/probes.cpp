#include "04-point-shadows/given/probes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "03-shadow-mapping/given/shaders_alone.hpp"
#include "04-point-shadows/point_shadows.hpp"
#include "app/probe_depth_pass.hpp"
#include "app/probe_texture.hpp"
#include "gl/depth_textures.hpp"
#include "gl/full_screen.hpp"
#include "gl/query.hpp"

namespace atelier {

namespace {

using namespace point_shadows;

/// The student's GLSL with one cube; `before` stands between its defines and itself.
std::string glsl(int bias, int pcf, bool compare, const std::string& before = "") {
  Defines defines = no_shadow_lights();
  defines.merge(Defines{{"CUBES", "1"}, {"BIAS", fmt::to_string(bias)}, {"PCF", fmt::to_string(pcf)}});
  if (compare) defines.emplace("COMPARE", "1");
  return text_including("04-point-shadows/point_shadows.glsl", defines, before);
}

const std::string light_of_arguments = "CubeLight(light_position, far, 0)";

/// A cube of 8 x 8 texels a face that holds 0.25 in its face +x, 0.5 in -x, 0.75 in +y, and 1 in the others, but for
/// the half of +z that lies towards +x, which is 0.25.
GlTexture uneven_cube(Gl& gl, bool compare) {
  constexpr int side = 8;
  std::vector<float> depths = even_faces(side, {0.25f, 0.5f, 0.75f, 1, 1, 1});
  for (int i = 0; i < side * side; ++i)
    if (i % side >= side / 2) depths[std::size_t(4 * side * side + i)] = 0.25f;
  return make_depth_cube(gl, side, depths, compare);
}

/// A probe of a GLSL expression that reads this cube.
Probe cube_probe(const std::string& preamble, bool compare, const std::string& expression) {
  return with_texture(
      GL_TEXTURE_CUBE_MAP, [compare](Gl& gl) { return uneven_cube(gl, compare); },
      shader_probe(preamble, expression, 1));
}

/// Filters, wraps, compare mode and function of the cube, edge and format of face -z; whether the framebuffer is
/// complete, layered, without colour, and whether filters reach across edges.
Numbers probe_make_cube_map(ProbeContext& context, const Arguments& in) {
  Gl& gl = context.gl;
  gl.Disable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  const CubeMap cube = make_cube_map(gl, in.integer("resolution"), depth_format_of(in), in.number("compare") > 0.5);
  const GlTexture texture(gl, cube.texture);
  const GlFramebuffer framebuffer(gl, cube.framebuffer);
  if (!texture || !framebuffer) return Numbers(16, 0);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, cube.texture);
  Numbers out;
  append(out, texture_parameters(gl, GL_TEXTURE_CUBE_MAP,
                                 {GL_TEXTURE_MAG_FILTER, GL_TEXTURE_MIN_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T,
                                  GL_TEXTURE_WRAP_R, GL_TEXTURE_COMPARE_MODE, GL_TEXTURE_COMPARE_FUNC}));
  append(out, level_parameters(gl, GL_TEXTURE_CUBE_MAP_NEGATIVE_Z,
                               {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_INTERNAL_FORMAT}));
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, 0);
  gl.BindFramebuffer(GL_FRAMEBUFFER, cube.framebuffer);
  out.push_back(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
  GLint layered = 0;
  gl.GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_LAYERED,
                                         &layered);
  out.push_back(layered);
  out.push_back(integer_of(gl, GL_DRAW_BUFFER));
  out.push_back(integer_of(gl, GL_READ_BUFFER));
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  out.push_back(gl.IsEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS));
  out.push_back(cube.resolution);
  return out;
}

/// What the pass has set, on a cube made by given code; then what the six faces hold, which was 0.5.
Numbers probe_begin_cube_pass(ProbeContext& context, const Arguments& in) {
  Gl& gl = context.gl;
  constexpr int side = 4;
  const GlTexture texture = make_depth_cube(gl, side, std::vector<float>(6 * side * side, 0.5f));
  const GlFramebuffer framebuffer = make_depth_framebuffer(gl);
  Numbers out = depth_pass_state(gl, [&] {
    begin_cube_pass(gl, {texture.id(), framebuffer.id(), side}, in.integer("face"), in.number("cull_front") > 0.5);
  });
  const std::vector<float> depths = read_depth_cube(gl, texture.id());
  for (std::size_t face = 0; face < 6; ++face) out.push_back(depths[face * side * side + 5]);
  return out;
}

/// One triangle, spread over faces by draw_in_faces; what is stored is g_position_world.z. The corners are (-1, -1),
/// (0.9, -1) and (-1, 0.9), with z = (x + 1) / 16.
GlProgram spreading_program(ProbeContext& context) {
  const FindFile find = [&](const std::string& name) { return context.shaders.find(name); };
  const auto stage = [&](const char* text, const char* label) { return assemble_shader_text(find, text, label, {}); };
  const ShaderSource geometry = stage(
      "#define GEOMETRY\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 18) out;\n"
      "in vec3 v_corner_world[];\nout vec3 g_position_world;\n"
      "uniform mat4 u_face_matrices[6];\nuniform float u_face_wanted[6];\n"
      "#include \"04-point-shadows/cube_pass.glsl\"\nvoid main() { draw_in_faces(); }\n",
      "probe geometry shader");
  return build_program(
      context.gl,
      stage("out vec3 v_corner_world;\nvoid main() {\n"
            "  vec2 corner = vec2(gl_VertexID == 1 ? 0.9 : -1.0, gl_VertexID == 2 ? 0.9 : -1.0);\n"
            "  v_corner_world = vec3(corner, (corner.x + 1.0) / 16.0);\n}\n",
            "probe vertex shader"),
      stage("in vec3 g_position_world;\nvoid main() { gl_FragDepth = g_position_world.z; }\n", "probe fragment shader"),
      &geometry);
}

/// Face i's matrix moves everything i of `side` texels up and, where i is odd, mirrors it: so each face tells what was
/// meant for it, and triangles that join two faces are seen.
void set_faces(Gl& gl, const GlProgram& program, int side, const std::vector<double>& wanted) {
  gl.UseProgram(program.id());
  for (int face = 0; face < 6; ++face) {
    glm::mat4 matrix(1.0f);
    matrix[2][2] = 0;  // the depth that is stored is the fragment shader's
    matrix[3][1] = 2.0f * float(face) / float(side);
    if (face % 2 == 1) matrix[0][0] = -1;
    const auto at = [&](const char* name) {
      return gl.GetUniformLocation(program.id(), fmt::format("{}[{}]", name, face).c_str());
    };
    const float want = float(wanted.at(std::size_t(face)));
    gl.UniformMatrix4fv(at("u_face_matrices"), 1, GL_FALSE, &matrix[0][0]);
    gl.Uniform1fv(at("u_face_wanted"), 1, &want);
  }
}

/// What draw_in_faces makes of the triangle above in a cube of 8 x 8 texels a face: of each face, how many texels are
/// covered, and what arrives in columns 0, 3 and 7 of row `face`; 1 where nothing was drawn.
Numbers probe_draw_in_faces(ProbeContext& context, const Arguments& in) {
  Gl& gl = context.gl;
  constexpr int side = 8;
  const GlProgram program = spreading_program(context);
  const GlTexture texture = make_depth_cube(gl, side, std::vector<float>(6 * side * side, 1.0f));
  const GlFramebuffer framebuffer = make_depth_framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  gl.FramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture.id(), 0);
  gl.Viewport(0, 0, side, side);
  gl.Enable(GL_DEPTH_TEST);
  gl.Disable(GL_CULL_FACE);

  set_faces(gl, program, side, in.numbers("wanted"));
  draw_triangle_by_id(gl);
  check_gl_error(gl, "drawing a triangle into the faces of a cube");
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);

  const std::vector<float> depths = read_depth_cube(gl, texture.id());
  Numbers out;
  for (int face = 0; face < 6; ++face) {
    const float* texels = &depths[std::size_t(face * side * side)];
    out.push_back(double(std::count_if(texels, texels + side * side, [](float depth) { return depth < 1; })));
    for (const int column : {0, 3, 7}) out.push_back(texels[face * side + column]);
  }
  return out;
}

/// The cone around spheres that are given as x y z radius, one after another (fewer than four numbers: none): 1, axis
/// and half-angle, or zeros.
Numbers probe_cone_around(ProbeContext&, const Arguments& in) {
  std::vector<Sphere> spheres;
  const std::vector<double>& n = in.numbers("spheres");
  for (std::size_t i = 0; i + 3 < n.size(); i += 4)
    spheres.push_back({{float(n[i]), float(n[i + 1]), float(n[i + 2])}, float(n[i + 3])});
  const auto cone = cone_around(glm::vec3(in.vec3("position")), spheres, float(in.number("widest")));
  if (!cone) return Numbers(5, 0);
  return {1, cone->axis.x, cone->axis.y, cone->axis.z, cone->half_angle};
}

}  // namespace

std::map<std::string, Probe> point_shadow_probes() {
  const std::string pass = text_including("04-point-shadows/cube_pass.glsl", {{"FRAGMENT", ""}});
  std::map<std::string, Probe> probes = {
      {"make_cube_map", probe_make_cube_map},
      {"begin_cube_pass", probe_begin_cube_pass},
      {"draw_in_faces", probe_draw_in_faces},
      {"face_view",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(face_view(glm::vec3(in.vec3("position")), in.integer("face")));
       }},
      {"face_view_refuses",
       [](ProbeContext&, const Arguments& in) {
         return refuses([&] { face_view(glm::vec3(0), in.integer("face")); });
       }},
      {"face_projection",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(face_projection(float(in.number("near")), float(in.number("far"))));
       }},
      {"cone_around", probe_cone_around},
      {"stored_distance", shader_probe(pass, "vec4(stored_distance(position, light_position, far))", 1)},
      {"cube_texel", shader_probe(glsl(0, 1, false), "vec4(cube_texel(from_light, resolution))", 1)},
      {"compare_cube_distance",
       cube_probe(glsl(0, 1, false), false, "vec4(compare_cube_distance(0, from_light, reference))")},
      {"compare_cube_distance_bilinear",
       cube_probe(glsl(0, 1, true), true, "vec4(compare_cube_distance(0, from_light, reference))")},
  };
  const std::string filtered = "vec4(cube_pcf(" + light_of_arguments + ", from_light, reference))",
                    factor = "vec4(point_shadow_factor(" + light_of_arguments + ", position, normal, to_light))";
  probes["cube_pcf"] = cube_probe(glsl(0, 3, false), false, filtered);
  probes["cube_pcf_even"] = cube_probe(glsl(0, 2, false), false, filtered);
  for (int bias = 0; bias <= 4; ++bias)
    probes[fmt::format("point_shadow_factor_{}", bias)] =
        cube_probe(glsl(bias, 1, false, bias_as_argument), false, factor);
  return probes;
}

}  // namespace atelier
