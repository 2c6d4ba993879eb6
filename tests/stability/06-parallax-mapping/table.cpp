// Step 06's table of extremes. The relief is a texture of a test: heights 0 and 1 everywhere, one texel, a spike.
#include "stability/entry.hpp"
#include "stability/rows.hpp"

namespace atelier::stability {

namespace {

/// A height map of these texels, from the bottom row up. It lives as long as the context.
GLuint height_map(Gl& gl, int width, int height, const std::vector<float>& heights) {
  GLuint map = 0;
  gl.GenTextures(1, &map);
  gl.BindTexture(GL_TEXTURE_2D, map);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, width, height, 0, GL_RED, GL_FLOAT, heights.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return map;
}

ShaderFunction relief_function(std::vector<std::string> parameters, std::string expression, GLuint map) {
  return {.source = text_including("06-parallax-mapping/parallax_mapping.glsl"),
          .parameters = std::move(parameters),
          .expression = std::move(expression),
          .textures = {{"u_height_map", map}}};
}

void add_span_rows(Table& table, ShaderFunctions& shaders, GLuint flat) {
  Group group = table.of("parallax_span (GLSL)");
  const ShaderFunction function = relief_function({"v", "d"}, "vec4(parallax_span(v.xyz, d.x), 0.0, 0.0)", flat);
  const auto of = [=, &shaders](glm::vec3 v, float depth) {
    return values(glm::vec2(shaders.evaluate(function, input_of(v, depth))));
  };
  group.equals("from straight above", [=] { return of({0, 0, 1}, 0.1f); }, {0, 0});
  group.equals("depth 0", [=] { return of({0.6f, 0, 0.8f}, 0); }, {0, 0});
  for (const float z : {0.05f, 0.01f, 0.0f, -0.5f})
    group.close(fmt::format("z of {:g} counts as 0.05", z), {2e-6, "relative", "a quotient and a product"}, [=] {
      return relative_difference(of({1, 0, z}, 0.1f), {-2, 0});
    });
  group.equals("NaN in x", [=] { return of({not_a_number, 0, 1}, 0.1f); }, {0, 0});
  group.equals("NaN in z", [=] { return of({0, 0, not_a_number}, 0.1f); }, {0, 0});
}

void add_march_rows(Table& table, ShaderFunctions& shaders, GLuint high, GLuint low) {
  Group group = table.of("first_step_below (GLSL)");
  const std::string expression = "vec4(first_step_below(t.xy, t.zw, int(n.x)), 0.0, 0.0)";
  const auto of = [&shaders](const ShaderFunction& function, glm::vec2 span, float layers) {
    return values(glm::vec2(shaders.evaluate(function, input_of(glm::vec4(0.3f, 0.4f, span.x, span.y), layers))));
  };
  const ShaderFunction on_high = relief_function({"t", "n"}, expression, high);
  const ShaderFunction on_low = relief_function({"t", "n"}, expression, low);
  for (const float layers : {1.0f, 2.0f, 256.0f}) {
    group.equals(fmt::format("height 1 everywhere, {:g} layers", layers),
                 [=] {
                   return of(on_high, {1, 1}, layers);
                 },
                 {0, 0});
    group.equals(fmt::format("height 0 everywhere, {:g} layers", layers),
                 [=] {
                   return of(on_low, {1, 1}, layers);
                 },
                 {1 - 1 / double(layers), 1});
  }
  group.equals("a span of 1e6", [=] { return of(on_low, {1e6f, 0}, 4); }, {0.75, 1});
  group.equals("no span", [=] { return of(on_low, {0, 0}, 4); }, {0.75, 1});
}

void add_hit_rows(Table& table, ShaderFunctions& shaders, GLuint high, GLuint low, GLuint slope) {
  const auto secant = [](GLuint map) { return relief_function({"t", "s"}, "vec4(secant_hit(t.xy, t.zw, s.xy))", map); };
  const auto halved = [](GLuint map) {
    return relief_function({"t", "s"}, "vec4(bisected_hit(t.xy, t.zw, s.xy, int(s.z)))", map);
  };
  const auto of = [&shaders](const ShaderFunction& function, glm::vec3 step) {
    return Values{shaders.number(function, input_of(glm::vec4(0.25f, 0.5f, 0.5f, 0), step))};
  };
  Group secants = table.of("secant_hit (GLSL)");
  secants.equals("on the relief at both ends", [=] { return of(secant(high), {0, 0, 0}); }, {0});
  secants.equals("an empty step", [=] { return of(secant(low), {1, 1, 0}); }, {1});
  secants.equals("height 0, the whole way", [=] { return of(secant(low), {0, 1, 0}); }, {1});
  // From (0.25, height 1) to (0.75, height 0) above a height that rises from 0 to 1: they meet in the middle.
  secants.close("a plane is found by one step", {2e-6, "absolute", "filtered texels and a quotient"}, [=] {
    return difference(of(secant(slope), {0, 1, 0}), {0.5});
  });
  Group halvings = table.of("bisected_hit (GLSL)");
  halvings.equals("0 bisections", [=] { return of(halved(slope), {0.25f, 0.75f, 0}); }, {0.5});
  for (const float bisections : {1.0f, 8.0f, 16.0f})
    halvings.close(fmt::format("{:g} bisections of a plane", bisections),
                   {double(std::exp2(-bisections - 1)) + 1e-6, "absolute", "half of what is left of the step"}, [=] {
                     return difference(of(halved(slope), {0, 1, bisections}), {0.5});
                   });
}

void add_layer_rows(Table& table, ShaderFunctions& shaders, GLuint flat) {
  Group group = table.of("layers_needed (GLSL)");
  const ShaderFunction function =
      relief_function({"s", "dx", "dy", "most"}, "vec4(layers_needed(s.xy, dx.xy, dy.xy, int(most.x)))", flat);
  const auto of = [=, &shaders](glm::vec2 span, glm::vec2 dx, glm::vec2 dy) {
    return Values{shaders.number(function, input_of(span, dx, dy, 64.0f))};
  };
  group.equals("no derivatives", [=] { return of({1, 0}, {0, 0}, {0, 0}); }, {64});
  group.equals("parallel derivatives", [=] { return of({1, 0}, {1, 2}, {2, 4}); }, {64});
  group.equals("no span", [=] { return of({0, 0}, {0.01f, 0}, {0, 0.01f}); }, {1});
  group.equals("a span of 1e6", [=] { return of({1e6f, 0}, {0.01f, 0}, {0, 0.01f}); }, {64});
  for (const float size : {1e-9f, 1e-3f, 1e3f})
    group.equals(fmt::format("two and a half pixels of {:g}", size),
                 [=] {
                   return of({2.5f * size, 0}, {size, 0}, {0, size});
                 },
                 {3});
}

void add_light_rows(Table& table, ShaderFunctions& shaders, GLuint high, GLuint low) {
  Group group = table.of("relief_visibility (GLSL)");
  const auto of = [&shaders](GLuint map, float height, float samples) {
    return Values{shaders.number(
        relief_function({"h", "n"}, "vec4(relief_visibility(vec2(0.3, 0.4), h.x, vec2(0.2, 0.1), int(n.x)))", map),
        input_of(height, samples))};
  };
  group.equals("on the surface", [=] { return of(high, 1, 32); }, {1});
  group.equals("at the bottom of a pit", [=] { return of(high, 0, 32); }, {0});
  group.equals("one sample", [=] { return of(high, 0, 1); }, {1});
  group.equals("no relief between point and light", [=] { return of(low, 0, 256); }, {1});
}

void add_place_rows(Table& table, ShaderFunctions& shaders, GLuint flat) {
  Group positions = table.of("relief_position (GLSL)");
  const ShaderFunction position =
      relief_function({"p", "e", "v", "d"}, "vec4(relief_position(p.xyz, e.xyz, v.xyz, d.x, d.y), 0.0)", flat);
  const auto at = [=, &shaders](glm::vec3 p, glm::vec3 eye, glm::vec3 v, glm::vec2 depth) {
    return values(glm::vec3(shaders.evaluate(position, input_of(p, eye, v, depth))));
  };
  positions.equals("t = 0", [=] { return at({1, 2, 3}, {4, 5, 6}, {0, 0, 1}, {1, 0}); }, {1, 2, 3});
  positions.equals("the eye on the surface", [=] { return at({1, 2, 3}, {1, 2, 3}, {0, 0, 1}, {1, 1}); }, {1, 2, 3});
  positions.close("straight down", {1e-6, "absolute", "a normalised vector"}, [=] {
    return difference(at({0, 0, 0}, {0, 4, 0}, {0, 0, 1}, {0.5f, 0.5f}), {0, -0.25, 0});
  });
  positions.close("along the surface: 20 depths", {1e-5, "relative", "a normalised vector"}, [=] {
    return relative_difference(at({0, 0, 0}, {4, 0, 0}, {1, 0, 0}, {0.5f, 1}), {-10, 0, 0});
  });

  Group depths = table.of("depth_of (GLSL)");
  const ShaderFunction depth =
      relief_function({"a", "b", "c", "d", "p"}, "vec4(depth_of(mat4(a, b, c, d), p.xyz))", flat);
  const glm::mat4 clip{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -11.0f / 9, -1}, {0, 0, -20.0f / 9, 0}};  // planes at 1, 10
  const auto stored = [=, &shaders](float z) {
    return Values{shaders.number(depth, input_of(clip[0], clip[1], clip[2], clip[3], glm::vec3(0.3f, 0.2f, z)))};
  };
  depths.close("at the near plane", {1e-6, "absolute", "a quotient"}, [=] { return difference(stored(-1), {0}); });
  depths.close("at the far plane", {1e-6, "absolute", "a quotient"}, [=] { return difference(stored(-10), {1}); });
  depths.finite("before the near plane", [=] { return stored(-1e-3f); });

  Group edges = table.of("beyond_edges (GLSL)");
  const ShaderFunction beyond = relief_function({"t"}, "vec4(beyond_edges(t.xy, vec2(0.0), vec2(1.0)))", flat);
  const auto outside = [=, &shaders](glm::vec2 t) { return Values{shaders.number(beyond, input_of(t))}; };
  edges.equals("on a corner", [=] { return outside({1, 1}); }, {0});
  edges.equals("a float beyond it", [=] { return outside({1 + 0x1p-23f, 0.5f}); }, {1});
  edges.equals("a little below 0", [=] { return outside({0.5f, -1e-30f}); }, {1});

  Group recorded = table.of("recorded_height (GLSL)");
  const ShaderFunction height = relief_function({"p"}, "vec4(recorded_height(p.xyz, 1.0, 3.0))", flat);
  const auto of = [=, &shaders](float z) { return Values{shaders.number(height, input_of(glm::vec3(5, 7, z)))}; };
  recorded.equals("at the nearest distance", [=] { return of(-1); }, {1});
  recorded.equals("at the farthest", [=] { return of(-3); }, {0});
  recorded.equals("behind the camera", [=] { return of(4); }, {1});
  recorded.equals("1e9 m away", [=] { return of(-1e9f); }, {0});
}

void add_offset_rows(Table& table, ShaderFunctions& shaders, GLuint high, GLuint low) {
  Group group = table.of("offset_hit (GLSL)");
  const auto of = [&shaders](GLuint map) {
    return Values{shaders.number(relief_function({"t"}, "vec4(offset_hit(t.xy))", map), input_of(glm::vec2(7.3f, -2)))};
  };
  group.equals("height 1, far outside of the texture", [=] { return of(high); }, {0});
  group.equals("height 0", [=] { return of(low); }, {1});
}

void add_curved_rows(Table& table, ShaderFunctions& shaders, GLuint high, GLuint low) {
  Group bends = table.of("ray_bend (GLSL)");
  const ShaderFunction bend = relief_function({"s", "d"}, "vec4(ray_bend(s.xy, d.x, d.y, d.z))", high);
  const auto bend_of = [=, &shaders](glm::vec2 span, glm::vec3 rest) {
    return Values{shaders.number(bend, input_of(span, rest))};
  };
  bends.equals("no span", [=] { return bend_of({0, 0}, {0.1f, 1, 5}); }, {0});
  bends.equals("a plane", [=] { return bend_of({1, 1}, {0.1f, 1, 0}); }, {0});
  for (const float size : {1e-3f, 1.0f, 1e3f})  // the same shape in other units
    for (const float curvature : {2.0f, -2.0f})
      bends.close(fmt::format("a texture of {:g} m, curvature {:g} / m", size, curvature / size),
                  {1e-6, "relative", "products and a quotient"}, [=] {
                    return relative_difference(bend_of({0.3f, 0.4f}, {0.125f, size, curvature / size}), {curvature});
                  });

  Group ends = table.of("ray_end (GLSL)");
  const ShaderFunction end = relief_function({"b"}, "vec4(ray_end(b.x))", high);
  const auto end_of = [=, &shaders](float b) { return Values{shaders.number(end, input_of(b))}; };
  // The smaller root by the form without cancellation, in double precision; beyond 1/4 the way out.
  const auto exact = [](double b) { return b <= 0.25 ? 2 / (1 + std::sqrt(1 - 4 * b)) : 1 / b; };
  ends.equals("bend 0", [=] { return end_of(0); }, {1});
  ends.equals("bend 1/4: it touches height 0", [=] { return end_of(0.25f); }, {2});
  for (const float b : {1e-30f, 1e-8f, 1e-6f, 1e-4f, 0.01f, 0.2499f, 0.25f + 0x1p-24f, 1.0f, 1e9f, 1e30f, -1e-30f,
                        -1e-8f, -1e-4f, -1.0f, -1e9f, -1e30f})
    ends.close(fmt::format("bend {:g}", b), {2e-6, "relative", "a root, a sum and a quotient"},
               [=] { return relative_difference(end_of(b), {exact(double(b))}); });

  Group hits = table.of("curved_hit (GLSL)");
  const auto hit_of = [&shaders](GLuint map, glm::vec2 span, float b, float layers) {
    return Values{
        shaders.number(relief_function({"s", "b"}, "vec4(curved_hit(vec2(0.3, 0.4), s.xy, b.x, int(b.y)))", map),
                       input_of(span, glm::vec2(b, layers)))};
  };
  for (const float layers : {1.0f, 2.0f, 256.0f})
    for (const float b : {-1e9f, 0.0f, 0.25f, 0.2501f, 1e9f}) {
      hits.equals(fmt::format("height 1 everywhere, bend {:g}, {:g} layers", b, layers),
                  [=] {
                    return hit_of(high, {1, 1}, b, layers);
                  },
                  {0});
      if (b > 0.25f)
        hits.equals(fmt::format("height 0 everywhere, bend {:g}, {:g} layers: past it", b, layers),
                    [=] {
                      return hit_of(low, {1, 1}, b, layers);
                    },
                    {-1});
      else
        hits.close(fmt::format("height 0 everywhere, bend {:g}, {:g} layers", b, layers),
                   {1e-5, "relative", "the height at the end is 0 up to the rounding of three terms"}, [=] {
                     return relative_difference(hit_of(low, {1, 1}, b, layers), {exact(double(b))});
                   });
    }
  hits.equals("a span of 1e6", [=] { return hit_of(low, {1e6f, 0}, 0, 4); }, {1});
}

}  // namespace

}  // namespace atelier::stability

void atelier_stability_table(atelier::stability::Table& table, atelier::stability::ShaderFunctions& shaders) {
  using namespace atelier::stability;
  atelier::Gl& gl = shaders.gl();
  const GLuint high = height_map(gl, 1, 1, {1}), low = height_map(gl, 1, 1, {0});
  const GLuint slope = height_map(gl, 2, 1, {0, 1});  // between the texels' centres the height is 2 (u - 1/4)
  add_span_rows(table, shaders, high);
  add_offset_rows(table, shaders, high, low);
  add_march_rows(table, shaders, high, low);
  add_hit_rows(table, shaders, high, low, slope);
  add_layer_rows(table, shaders, high);
  add_light_rows(table, shaders, high, low);
  add_place_rows(table, shaders, high);
  add_curved_rows(table, shaders, high, low);
}
