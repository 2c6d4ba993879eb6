#include "03-shadow-mapping/given/probes.hpp"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "03-shadow-mapping/given/shaders_alone.hpp"
#include "03-shadow-mapping/shadow_mapping.hpp"
#include "app/probe_depth_pass.hpp"
#include "app/probe_texture.hpp"
#include "gl/depth_textures.hpp"
#include "gl/query.hpp"

namespace atelier {

namespace {

using namespace shadow_mapping;

/// The student's GLSL without lights of its own: one comparison, no bias, unless `defines` choose another variant.
std::string glsl(Defines defines = {}, const std::string& before = "") {
  defines.merge(Defines{{"PCF", "1"}, {"BIAS", "0"}});
  defines.merge(no_shadow_lights());
  return text_including("03-shadow-mapping/shadow_mapping.glsl", defines, before);
}

/// A light of GLSL, from the arguments eye, direction, half_width, near, far, width, directional and layer.
const std::string light_of_arguments =
    "ShadowLight(world_to_map, eye, direction, half_width, near, far, width, directional > 0.5, int(layer))";
std::string plain_light(const std::string& layer = "0") {
  return "ShadowLight(mat4(1.0), vec3(0.0), vec3(0.0, -1.0, 0.0), half_width, near, far, width, directional > 0.5, " +
         layer + ")";
}

/// Two maps of 8 x 8 texels: the first 0.25 deep in its left half and 0.75 in its right, the second 0.5 all over.
GlTexture two_maps(Gl& gl, bool compare) {
  constexpr int side = 8;
  std::array<float, 2 * side * side> depths{};
  for (int i = 0; i < int(depths.size()); ++i)
    depths[std::size_t(i)] = i >= side * side ? 0.5f : i % side < side / 2 ? 0.25f : 0.75f;
  return make_depth_layers(gl, side, depths, compare);
}

/// A probe of a GLSL expression, a float, that reads these maps.
Probe map_probe(const Defines& defines, const std::string& expression, const std::string& before = "") {
  const bool compare = defines.contains("COMPARE");
  return with_texture(
      GL_TEXTURE_2D_ARRAY, [compare](Gl& gl) { return two_maps(gl, compare); },
      shader_probe(glsl(defines, before), "vec4(" + expression + ")", 1));
}

Sphere sphere_of(const Arguments& in) {
  return {glm::vec3(in.vec3("centre")), float(in.number("radius"))};
}

Numbers numbers_of(const LightFrustum& f) {
  return {f.eye.x, f.eye.y, f.eye.z, f.direction.x, f.direction.y, f.direction.z, f.extent, f.near, f.far};
}

LightFrustum frustum_of(const Arguments& in) {
  return {.orthographic = in.number("orthographic") > 0.5,
          .eye = glm::vec3(in.vec3("eye")),
          .direction = glm::vec3(in.vec3("direction")),
          .extent = float(in.number("extent")),
          .near = float(in.number("near")),
          .far = float(in.number("far"))};
}

/// Filters, wraps, compare mode and function, the border's red, width, height, layers and format of the texture; then
/// whether the framebuffer is complete, and its draw buffer.
Numbers probe_make_shadow_maps(ProbeContext& context, const Arguments& in) {
  Gl& gl = context.gl;
  const ShadowMaps maps = make_shadow_maps(gl, in.integer("resolution"), in.integer("layers"), depth_format_of(in),
                                           in.number("compare") > 0.5);
  const GlTexture texture(gl, maps.texture);
  const GlFramebuffer framebuffer(gl, maps.framebuffer);
  if (!texture || !framebuffer) return Numbers(14, 0);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, maps.texture);
  Numbers out;
  append(out, texture_parameters(gl, GL_TEXTURE_2D_ARRAY,
                                 {GL_TEXTURE_MAG_FILTER, GL_TEXTURE_MIN_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T,
                                  GL_TEXTURE_COMPARE_MODE, GL_TEXTURE_COMPARE_FUNC}));
  std::array<GLfloat, 4> border{};
  gl.GetTexParameterfv(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BORDER_COLOR, border.data());
  out.push_back(border[0]);
  append(out, level_parameters(gl, GL_TEXTURE_2D_ARRAY,
                               {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH, GL_TEXTURE_INTERNAL_FORMAT}));
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, 0);
  gl.BindFramebuffer(GL_FRAMEBUFFER, maps.framebuffer);
  out.push_back(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
  out.push_back(integer_of(gl, GL_DRAW_BUFFER));
  out.push_back(integer_of(gl, GL_READ_BUFFER));
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  return out;
}

/// What the pass has set, on maps made by given code; then the depths that layers 0 and 1 hold, which were 0.5.
Numbers probe_begin_depth_pass(ProbeContext& context, const Arguments& in) {
  Gl& gl = context.gl;
  constexpr int side = 4, layers = 2;
  const GlTexture texture = make_depth_layers(gl, side, std::vector<float>(layers * side * side, 0.5f));
  const GlFramebuffer framebuffer = make_depth_framebuffer(gl);
  Numbers out = depth_pass_state(gl, [&] {
    begin_depth_pass(gl, {texture.id(), framebuffer.id(), side, layers}, in.integer("layer"),
                     in.number("cull_front") > 0.5);
  });
  const std::vector<float> depths = read_depth_layers(gl, texture.id());
  out.push_back(depths.front());
  out.push_back(depths.back());
  return out;
}

}  // namespace

std::map<std::string, Probe> shadow_mapping_probes() {
  const Defines pcf3{{"PCF", "3"}}, compare{{"COMPARE", "1"}}, pcf3_compare{{"PCF", "3"}, {"COMPARE", "1"}};
  const Defines pcss{{"PCSS", "1"}, {"SAMPLES", "16"}};
  std::map<std::string, Probe> probes = {
      {"make_shadow_maps", probe_make_shadow_maps},
      {"begin_depth_pass", probe_begin_depth_pass},
      {"fit_spot",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(fit_spot(glm::vec3(in.vec3("position")), glm::vec3(in.vec3("direction")),
                                    float(in.number("outer_angle")), sphere_of(in)));
       }},
      {"fit_directional",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(fit_directional(glm::vec3(in.vec3("direction")), sphere_of(in)));
       }},
      {"snap_to_texels",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(snap_to_texels(frustum_of(in), in.integer("resolution")));
       }},
      {"light_view", [](ProbeContext&, const Arguments& in) { return numbers_of(light_view(frustum_of(in))); }},
      {"light_projection",
       [](ProbeContext&, const Arguments& in) { return numbers_of(light_projection(frustum_of(in))); }},
      {"bias_matrix", [](ProbeContext&, const Arguments&) { return numbers_of(bias_matrix()); }},
      {"depth_pass_position",
       shader_probe(text_including("03-shadow-mapping/depth_pass.glsl"),
                    "depth_pass_position(position) + 0.0 * u_view[0] + 0.0 * u_projection[0]", 4)},
      {"shadow_coordinate", shader_probe(glsl(), "vec4(shadow_coordinate(world_to_map, position), 0.0)", 3)},
      {"map_width", shader_probe(glsl(), "vec4(map_width(" + plain_light() + ", depth))", 1)},
      {"constant_bias", shader_probe(glsl(), "vec4(constant_bias(position, to_light, amount), 0.0)", 3)},
      {"slope_bias", shader_probe(glsl(), "vec4(slope_bias(position, normal, to_light, axis, amount), 0.0)", 3)},
      {"normal_offset", shader_probe(glsl(), "vec4(normal_offset(position, normal, axis, amount), 0.0)", 3)},
      {"plane_slope", shader_probe(glsl(), "vec4(plane_slope(dx, dy), 0.0, 0.0)", 2)},
      {"linear_depth", shader_probe(glsl(), "vec4(linear_depth(" + plain_light() + ", z))", 1)},
      {"penumbra_width", shader_probe(glsl(), "vec4(penumbra_width(" + plain_light() + ", receiver, blocker))", 1)},
      {"compare_depth", map_probe({}, "compare_depth(coordinate, int(layer))")},
      {"compare_depth_bilinear", map_probe(compare, "compare_depth(coordinate, int(layer))")},
      {"pcf", map_probe(pcf3, "pcf(coordinate, slope, int(layer))")},
      {"pcf_even", map_probe({{"PCF", "2"}}, "pcf(coordinate, slope, int(layer))")},
      {"pcf_wide", map_probe({{"PCF", "5"}}, "pcf(coordinate, slope, int(layer))")},
      {"pcf_bilinear", map_probe(pcf3_compare, "pcf(coordinate, slope, int(layer))")},
      {"blocker_depth", map_probe(pcss, "blocker_depth(" + plain_light("int(layer)") + ", coordinate, slope, search)")},
      {"pcss", map_probe(pcss, "pcss(" + plain_light("int(layer)") + ", coordinate, slope, receiver)")},
  };
  const std::string factor = "shadow_factor(" + light_of_arguments + ", position, normal, to_light)";
  for (int bias = 0; bias <= 4; ++bias)
    probes[fmt::format("shadow_factor_{}", bias)] =
        map_probe({{"BIAS", fmt::to_string(bias)}}, factor, bias_as_argument);
  probes["shadow_factor_filtered"] = map_probe({{"BIAS", "1"}, {"PCF", "3"}}, factor, bias_as_argument);
  return probes;
}

}  // namespace atelier
