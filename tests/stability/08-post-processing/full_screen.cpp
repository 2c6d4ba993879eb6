// next_target, draw_full_screen, full_screen_corner: long chains, pictures of one pixel and of the longest side.
#include "gl/query.hpp"
#include "gl/state.hpp"
#include "gl/target.hpp"
#include "stability/08-post-processing/rows.hpp"

namespace atelier::stability {

using namespace post_processing;

namespace {

constexpr const char* corners_by_number =
    "#include \"08-post-processing/post_processing.glsl\"\n"
    "void main() { gl_Position = vec4(full_screen_corner(gl_VertexID), 0.0, 1.0); }\n";
constexpr const char* with_texcoord =
    "layout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\nout vec2 g_texcoord;\n"
    "void main() {\n"
    "  for (int i = 0; i < 3; ++i) {\n"
    "    gl_Position = gl_in[i].gl_Position;\n"
    "    g_texcoord = gl_in[i].gl_Position.xy * 0.5 + 0.5;\n"
    "    EmitVertex();\n"
    "  }\n"
    "  EndPrimitive();\n"
    "}\n";
/// Red: how often a pixel is drawn. Green: pixels between its centre and the place that it would read.
constexpr const char* counted =
    "uniform vec2 u_size;\nin vec2 g_texcoord;\nout vec4 o_value;\n"
    "void main() {\n"
    "  vec2 off = abs(g_texcoord * u_size - gl_FragCoord.xy);\n"
    "  o_value = vec4(1.0, max(off.x, off.y), 0.0, 0.0);\n"
    "}\n";

Image drawn_full_screen(ShaderFunctions& shaders, int width, int height) {
  Gl& gl = shaders.gl();
  const Target target(gl, {.width = width, .height = height, .depth = DepthFormat::none});
  const GLuint program = shaders.pipeline(corners_by_number, with_texcoord, counted);
  reset_state(gl);
  target.bind(gl);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  gl.UseProgram(program);
  Uniforms(gl, program).set("u_size", glm::vec2(width, height));
  draw_full_screen(gl);
  reset_state(gl);
  check_gl_error(gl, "draw_full_screen");
  return target.read_colour(gl);
}

double count_vertex_arrays(Gl& gl) {
  double count = 0;
  for (GLuint name = 1; name <= 4096; ++name) count += gl.IsVertexArray(name) == GL_TRUE ? 1 : 0;
  return count;
}

/// After 1000 draws into one pixel: vertex arrays that are left, which one is bound, vertices, OpenGL's error.
Values after_thousand_draws(ShaderFunctions& shaders) {
  Gl& gl = shaders.gl();
  const Target target(gl, {.width = 1, .height = 1, .depth = DepthFormat::none});
  reset_state(gl);
  target.bind(gl);
  gl.UseProgram(shaders.pipeline(corners_by_number, with_texcoord, counted));
  const double before = count_vertex_arrays(gl);
  gl.restart_counts();
  for (int i = 0; i < 1000; ++i) draw_full_screen(gl);
  const Values after = {count_vertex_arrays(gl) - before, double(integer_of(gl, GL_VERTEX_ARRAY_BINDING)),
                        double(gl.counts().vertices), double(gl.GetError())};
  reset_state(gl);
  return after;
}

}  // namespace

void add_target_rows(Table& table) {
  Group group = table.of("next_target");
  group.equals("a chain of 10000 passes: targets that are read and written at once, or that are neither 0 nor 1",
               [] {
                 double wrong = 0;
                 for (int pass = 0, source = -1; pass < 10'000; ++pass) {
                   const int target = next_target(source);
                   wrong += target == source || (target != 0 && target != 1);
                   source = target;
                 }
                 return Values{wrong};
               },
               {0});
}

void add_full_screen_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("draw_full_screen, full_screen_corner (GLSL)");
  for (const auto& [width, height] :
       {std::pair{1, 1}, {1, 7}, {7, 1}, {333, 257}, {Image::max_side, 1}, {1, Image::max_side}}) {
    group.equals(fmt::format("{} x {}: pixels that are not drawn exactly once", width, height),
                 [=, &shaders, width = width, height = height] {
                   double others = 0;
                   const Image drawn = drawn_full_screen(shaders, width, height);
                   for (const Rgba& p : drawn.pixels()) others += p.r != 1;
                   return Values{others};
                 },
                 {0});
    group.close(
        fmt::format("{} x {}: each pixel reads its own place", width, height),
        {1.0 / 256, "pixels",
         "a coordinate of up to 2 is rounded to 1.2e-7 of it: 0.002 pixels of 16384; its texel ends half a pixel "
         "away"},
        [=, &shaders, width = width, height = height] {
          double worst = 0;
          const Image drawn = drawn_full_screen(shaders, width, height);
          for (const Rgba& p : drawn.pixels()) worst = std::max(worst, double(p.g));
          return worst;
        });
  }
  group.equals("1000 draws: vertex arrays left, vertex array bound, vertices, OpenGL's error",
               [&shaders] { return after_thousand_draws(shaders); }, {0, 0, 3000, 0});

  Group corners = table.of("full_screen_corner (GLSL)");
  const ShaderFunction function = post_function({"i"}, "vec4(full_screen_corner(int(i.x)), 0.0, 0.0)");
  const auto side_of = [=, &shaders](int from, const glm::dvec2& p) {  // above 0: to the left of the side
    const glm::dvec2 a(shaders.evaluate(function, input_of(float(from)))),
        b(shaders.evaluate(function, input_of(float((from + 1) % 3))));
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  };
  corners.equals("corners of the picture that are to the right of a side",
                 [=] {
                   double outside = 0;
                   for (int side = 0; side < 3; ++side)
                     for (const double x : {-1.0, 1.0})
                       for (const double y : {-1.0, 1.0}) outside += !(side_of(side, {x, y}) >= 0);
                   return Values{outside};
                 },
                 {0});
}

}  // namespace atelier::stability
