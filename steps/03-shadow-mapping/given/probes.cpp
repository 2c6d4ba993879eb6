#include "03-shadow-mapping/given/probes.hpp"

#include <fmt/core.h>

#include <array>

#include "03-shadow-mapping/given/depth_probe.hpp"
#include "03-shadow-mapping/shadow_mapping.hpp"
#include "gl/query.hpp"

namespace atelier {

namespace {

using namespace shadow_mapping;

/// The student's GLSL without lights of its own; `defines` choose the variant.
std::string glsl(const std::string& defines = "") {
  return "#define POINT_LIGHTS 0\n#define SPOT_LIGHTS 0\n#define DIRECTIONAL_LIGHTS 0\n#define SHADOW_LIGHTS 0\n" +
         std::string(defines.find("define PCF") == std::string::npos ? "#define PCF 1\n" : "") +
         std::string(defines.find("define BIAS") == std::string::npos ? "#define BIAS 0\n" : "") + defines +
         "#include \"03-shadow-mapping/shadow_mapping.glsl\"\n";
}

/// A light of GLSL, from the arguments eye, direction, half_width, near, far, width, directional and layer.
const std::string light_of_arguments =
    "ShadowLight(world_to_map, eye, direction, half_width, near, far, width, directional > 0.5, int(layer))";
const std::string plain_light =
    "ShadowLight(mat4(1.0), vec3(0.0), vec3(0.0, -1.0, 0.0), half_width, near, far, width, directional > 0.5, 0)";

/// Two maps of 8 x 8 texels: the first 0.25 deep in its left half and 0.75 in its right, the second 0.5 all over. Bound
/// to texture unit 0 as long as it lives.
class TestMaps {
 public:
  TestMaps(Gl& gl, bool compare) : gl_(gl), texture_(gl) {
    constexpr int side = 8;
    std::array<float, 2 * side * side> depths{};
    for (int i = 0; i < int(depths.size()); ++i)
      depths[std::size_t(i)] = i >= side * side ? 0.5f : i % side < side / 2 ? 0.25f : 0.75f;
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D_ARRAY, texture_.id());
    gl.TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, side, side, 2, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                  depths.data());
    const GLint filter = compare ? GL_LINEAR : GL_NEAREST;
    for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      gl.TexParameteri(GL_TEXTURE_2D_ARRAY, name, filter);
    for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
      gl.TexParameteri(GL_TEXTURE_2D_ARRAY, name, GL_CLAMP_TO_BORDER);
    const glm::vec4 farthest(1);
    gl.TexParameterfv(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BORDER_COLOR, &farthest[0]);
    if (compare) gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  }
  ~TestMaps() { gl_.BindTexture(GL_TEXTURE_2D_ARRAY, 0); }
  TestMaps(const TestMaps&) = delete;
  TestMaps& operator=(const TestMaps&) = delete;

 private:
  Gl& gl_;
  GlTexture texture_;
};

/// A probe of a GLSL expression that reads the test maps.
Probe map_probe(const std::string& defines, const std::string& expression, int components) {
  const bool compare = defines.find("COMPARE") != std::string::npos;
  return [=, probe = shader_probe(glsl(defines), expression, components)](ProbeContext& context, const Arguments& in) {
    const TestMaps maps(context.gl, compare);
    return probe(context, in);
  };
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
  std::array<GLint, 4> border{};
  gl.GetTexParameteriv(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BORDER_COLOR, border.data());
  out.push_back(border[0] > 0);
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

/// What the pass has set, on maps made by given code and after everything was set otherwise: viewport, depth test,
/// function, writing and clamping, culling and its face; then the depths that layers 0 and 1 hold, which were 0.5.
Numbers probe_begin_depth_pass(ProbeContext& context, const Arguments& in) {
  Gl& gl = context.gl;
  constexpr int side = 4;
  const GlTexture texture(gl);
  const GlFramebuffer framebuffer(gl);
  std::array<float, 2 * side * side> depths{};
  depths.fill(0.5f);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, texture.id());
  gl.TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, side, side, 2, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                depths.data());
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, 0);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  set_against_depth_pass(gl);

  begin_depth_pass(gl, {texture.id(), framebuffer.id(), side, 2}, in.integer("layer"), in.number("cull_front") > 0.5);

  Numbers out = depth_pass_state(gl);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, texture.id());
  gl.GetTexImage(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, 0);
  out.push_back(depths.front());
  out.push_back(depths.back());
  end_depth_pass(gl);
  return out;
}

}  // namespace

std::map<std::string, Probe> shadow_mapping_probes() {
  const std::string pcf3 = "#define PCF 3\n", compare = "#define COMPARE 1\n";
  const std::string pcss = "#define PCSS 1\n#define SAMPLES 16\n";
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
       shader_probe("#include \"03-shadow-mapping/depth_pass.glsl\"\n",
                    "depth_pass_position(position) + 0.0 * u_view[0] + 0.0 * u_projection[0]", 4)},
      {"shadow_coordinate", shader_probe(glsl(), "vec4(shadow_coordinate(world_to_map, position), 0.0)", 3)},
      {"map_width", shader_probe(glsl(), "vec4(map_width(" + plain_light + ", depth))", 1)},
      {"constant_bias", shader_probe(glsl(), "vec4(constant_bias(position, to_light, amount), 0.0)", 3)},
      {"slope_bias", shader_probe(glsl(), "vec4(slope_bias(position, normal, to_light, axis, amount), 0.0)", 3)},
      {"normal_offset", shader_probe(glsl(), "vec4(normal_offset(position, normal, axis, amount), 0.0)", 3)},
      {"plane_slope", shader_probe(glsl(), "vec4(plane_slope(dx, dy), 0.0, 0.0)", 2)},
      {"linear_depth", shader_probe(glsl(), "vec4(linear_depth(" + plain_light + ", z))", 1)},
      {"penumbra_width", shader_probe(glsl(), "vec4(penumbra_width(" + plain_light + ", receiver, blocker))", 1)},
      {"compare_depth", map_probe("", "vec4(compare_depth(coordinate, int(layer)))", 1)},
      {"compare_depth_bilinear", map_probe(compare, "vec4(compare_depth(coordinate, int(layer)))", 1)},
      {"pcf", map_probe(pcf3, "vec4(pcf(coordinate, slope, int(layer)))", 1)},
      {"pcf_bilinear", map_probe(pcf3 + compare, "vec4(pcf(coordinate, slope, int(layer)))", 1)},
      {"blocker_depth", map_probe(pcss, "vec4(blocker_depth(" + plain_light + ", coordinate, slope, search))", 1)},
      {"pcss", map_probe(pcss, "vec4(pcss(" + plain_light + ", coordinate, slope, receiver))", 1)},
  };
  for (int bias = 0; bias <= 3; ++bias)
    probes[fmt::format("shadow_factor_{}", bias)] =
        map_probe(fmt::format("#define BIAS {}\n", bias) + "#define PCF 1\n" + bias_as_argument,
                  "vec4(shadow_factor(" + light_of_arguments + ", position, normal, to_light))", 1);
  return probes;
}

}  // namespace atelier
