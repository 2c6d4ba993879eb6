#include "render/surface_shader.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>

namespace atelier {

namespace {

/// The renderer's own intermediates, as vec3 expressions over `surface`.
const std::map<std::string, std::string>& own_outputs() {
  static const std::map<std::string, std::string> outputs = {
      {"depth", "vec3(gl_FragCoord.z)"},
      {"normal", "encode_direction(surface.normal_world)"},
      {"position", "surface.position_world"},
      {"texcoord", "vec3(surface.texcoord, 0.0)"},
  };
  return outputs;
}

constexpr const char* vertex_text = R"(
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_texcoord;
uniform mat4 u_model, u_view, u_projection;
uniform mat3 u_normal_matrix;
uniform vec3 u_eye_world;
out vec3 v_position_world;
out vec3 v_normal_world;
out vec2 v_texcoord;
)";

constexpr const char* fragment_text = R"(
in vec3 v_position_world;
in vec3 v_normal_world;
in vec2 v_texcoord;
uniform vec3 u_eye_world;
out vec4 o_colour;

// A direction as a colour: -1..1 becomes 0..1. The zero vector becomes middle grey.
vec3 encode_direction(vec3 v) {
  float length_squared = dot(v, v);
  return length_squared > 0.0 ? v * inversesqrt(length_squared) * 0.5 + 0.5 : vec3(0.5);
}
)";

/// What fills a slot: the last feature's code, or nothing.
SlotCode code_for(Slot slot, const SurfaceKey& key) {
  SlotCode code;
  for (const Feature* feature : key.features) {
    const auto slots = feature->slots();
    if (const auto found = slots.find(slot); found != slots.end()) code = found->second;
  }
  return code;
}

std::string include_line(const std::string& file) {
  return fmt::format("#include \"{}\"\n", file);
}

/// The visibility of lights, under the names that shading code calls: declared before that code, defined behind it,
/// since both may stand in one file. Nothing where no feature knows about shadows.
struct Visibility {
  std::string before, behind;
};

Visibility visibility_text(const SurfaceKey& key) {
  Visibility text;
  bool any = false;
  for (const auto& [slot, type] : {std::pair{Slot::visible_from_point, "point"},
                                   {Slot::visible_from_spot, "spot"},
                                   {Slot::visible_from_sun, "sun"}}) {
    const SlotCode code = code_for(slot, key);
    const std::string head =
        fmt::format("float visible_from_{}(int light, vec3 position, vec3 normal, vec3 to_light)", type);
    text.before += head + ";\n";
    if (!code.include.empty()) text.behind += include_line(code.include);
    text.behind += fmt::format("{} {{ return {}; }}\n", head,
                               code.function.empty() ? "1.0" : code.function + "(light, position, normal, to_light)");
    any |= !code.function.empty();
  }
  return any ? text : Visibility{};
}

std::string output_expression(const SurfaceKey& key, const std::string& shaded) {
  if (key.output == "colour") return shaded;
  if (const auto own = own_outputs().find(key.output); own != own_outputs().end()) return own->second;
  std::vector<std::string> known = {"colour"};
  for (const auto& [name, expression] : own_outputs()) known.push_back(name);
  for (const Feature* feature : key.features)
    for (const auto& [name, expression] : feature->outputs()) {
      if (name == key.output) return expression;
      known.push_back(name);
    }
  throw Error(fmt::format("output '{}': this scene offers {}", key.output, fmt::join(known, ", ")));
}

}  // namespace

bool SurfaceKey::has(const Feature& feature) const {
  return std::find(features.begin(), features.end(), &feature) != features.end();
}

bool SurfaceKey::operator<(const SurfaceKey& other) const {
  return std::tie(features, structure, output) < std::tie(other.features, other.structure, other.output);
}

std::string pass_vertex_text(const std::string& transforms_glsl) {
  return R"(
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_texcoord;
uniform mat4 u_model, u_view, u_projection;
)" + include_line(transforms_glsl);
}

std::vector<std::string> surface_outputs() {
  std::vector<std::string> names;
  for (const auto& [name, expression] : own_outputs()) names.push_back(name);
  return names;
}

SurfaceSources assemble_surface(const FindFile& find, const std::string& transforms_glsl, const SurfaceKey& key) {
  // Where no feature shades the surface there is nothing but a flat grey: a silhouette.
  const SlotCode shade = code_for(Slot::shade, key);
  const bool per_vertex = key.structure.contains("PER_VERTEX") && key.output == "colour" && !shade.function.empty();
  const Visibility visibility = visibility_text(key);
  const std::string shading = shade.include.empty() ? ""
                                                    : include_line("surface.glsl") + visibility.before +
                                                          include_line(shade.include) + visibility.behind;
  const std::string shaded = shade.function.empty() ? "vec3(0.5)" : shade.function + "(surface)";

  // Vertex stage: step 01's functions place the corner; Gouraud shading also lights it here.
  std::string vertex = vertex_text + include_line(transforms_glsl);
  if (per_vertex) vertex += "out vec3 v_shaded;\n" + shading;
  vertex +=
      "void main() {\n"
      "  v_position_world = world_position(u_model, a_position);\n"
      "  v_normal_world = world_normal(u_normal_matrix, a_normal);\n"
      "  v_texcoord = a_texcoord;\n"
      "  gl_Position = clip_position(u_projection, u_view, u_model, a_position);\n";
  if (per_vertex)
    vertex += "  Surface surface = Surface(v_position_world, v_normal_world, v_texcoord, u_eye_world);\n  v_shaded = " +
              shaded + ";\n";
  vertex += "}\n";

  // Fragment stage: gather the surface, let the features shade it, write what was asked for.
  std::string fragment = fragment_text;
  if (per_vertex)
    fragment += "in vec3 v_shaded;\nvoid main() { o_colour = vec4(v_shaded, 1.0); }\n";
  else
    fragment += (shading.empty() ? include_line("surface.glsl") : shading) +
                "void main() {\n"
                "  Surface surface = Surface(v_position_world, v_normal_world, v_texcoord, u_eye_world);\n"
                "#ifdef TWO_SIDED\n"
                "  if (!gl_FrontFacing) surface.normal_world = -surface.normal_world;\n"
                "#endif\n"
                "  o_colour = vec4(" +
                output_expression(key, shaded) + ", 1.0);\n}\n";

  // The vertex stage is told of the structure only where it lights: one text for all other variants, so that the driver
  // compiles it once (Mesa keys its compiled code by the text's hash).
  return {assemble_shader_text(find, vertex, "surface vertex shader", per_vertex ? key.structure : Defines{}),
          assemble_shader_text(find, fragment, "surface fragment shader", key.structure)};
}

}  // namespace atelier
