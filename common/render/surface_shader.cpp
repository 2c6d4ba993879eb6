#include "render/surface_shader.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <tuple>

namespace atelier {

namespace {

/// The renderer's own intermediate results, as vec3 expressions of `surface`.
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

std::string include_line(const std::string& file) {
  return fmt::format("#include \"{}\"\n", file);
}

/// The code that fills a slot, in the order of the features.
std::vector<SlotCode> codes_for(Slot slot, const SurfaceKey& key) {
  std::vector<SlotCode> codes;
  for (const Feature* feature : key.features) {
    const auto slots = feature->slots();
    if (const auto found = slots.find(slot); found != slots.end()) codes.push_back(found->second);
  }
  return codes;
}

/// The code of slot `shade`, or none.
std::optional<SlotCode> shading_code(const SurfaceKey& key) {
  const std::vector<SlotCode> codes = codes_for(Slot::shade, key);
  if (codes.empty()) return {};
  if (codes.size() > 1)
    throw Error(
        fmt::format("two features shade the same surface, {} ({}) and {} ({}): use the slot modify_shaded in one of "
                    "them, or let only one of them need the node",
                    codes[0].function, codes[0].include, codes[1].function, codes[1].include));
  return codes[0];
}

struct VisibilitySlot {
  Slot slot;
  const char* light;
};
constexpr std::array<VisibilitySlot, 3> visibility_slots = {{{Slot::visible_from_point, "point"},
                                                             {Slot::visible_from_spot, "spot"},
                                                             {Slot::visible_from_directional, "directional"}}};

std::string visibility_head(const VisibilitySlot& slot) {
  return fmt::format("float visibility_of_{}_light(int light, vec3 position, vec3 normal, vec3 to_light)", slot.light);
}

bool knows_visibility(const SurfaceKey& key) {
  return std::ranges::any_of(visibility_slots,
                             [&](const VisibilitySlot& slot) { return !codes_for(slot.slot, key).empty(); });
}

/// Functions that multiply the features' results; declared before the features' code, which may call them.
std::string visibility_declarations() {
  std::string text;
  for (const VisibilitySlot& slot : visibility_slots) text += visibility_head(slot) + ";\n";
  return text;
}

std::string visibility_definitions(const SurfaceKey& key) {
  std::string text;
  for (const VisibilitySlot& slot : visibility_slots) {
    std::string product;
    for (const SlotCode& code : codes_for(slot.slot, key))
      product += fmt::format("{}{}(light, position, normal, to_light)", product.empty() ? "" : " * ", code.function);
    text += fmt::format("{} {{ return {}; }}\n", visibility_head(slot), product.empty() ? "1.0" : product);
  }
  return text;
}

/// What the shading stage needs before its main: the surface, and the code of these slots.
std::string features_text(const SurfaceKey& key, std::span<const Slot> slots) {
  std::string text = include_line("surface.glsl");
  const bool visibility = knows_visibility(key) && std::ranges::count(slots, Slot::shade) > 0;
  if (visibility) text += visibility_declarations();
  for (const Slot slot : slots)
    for (const SlotCode& code : codes_for(slot, key)) text += include_line(code.include);
  if (visibility) text += visibility_definitions(key);
  return text;
}

/// The statements that call a slot's functions.
std::string calls(Slot slot, const SurfaceKey& key, const char* statement) {
  std::string text;
  for (const SlotCode& code : codes_for(slot, key)) text += fmt::format(fmt::runtime(statement), code.function);
  return text;
}

/// If several features offer an output, the last one wins.
std::string output_expression(const SurfaceKey& key) {
  if (key.output == "colour") return "shaded";
  if (key.output == "depth" && key.structure.contains("FRAGMENT_DEPTH")) return "vec3(surface.depth)";
  if (const auto own = own_outputs().find(key.output); own != own_outputs().end()) return own->second;
  std::vector<std::string> known = {"colour"};
  for (const auto& [name, expression] : own_outputs()) known.push_back(name);
  std::string found;
  for (const Feature* feature : key.features)
    for (const auto& [name, expression] : feature->outputs()) {
      if (name == key.output) found = expression;
      known.push_back(name);
    }
  if (!found.empty()) return found;
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

namespace {

/// Slots of the fragment stage; with per-vertex lighting only some of them are left.
constexpr std::array all_slots = {Slot::displace_texcoord,
                                  Slot::modify_surface,
                                  Slot::discard_fragment,
                                  Slot::visible_from_point,
                                  Slot::visible_from_spot,
                                  Slot::visible_from_directional,
                                  Slot::shade,
                                  Slot::indirect,
                                  Slot::modify_shaded};
constexpr std::array lighting_slots = {Slot::visible_from_point, Slot::visible_from_spot,
                                       Slot::visible_from_directional, Slot::shade, Slot::indirect};
constexpr std::array slots_beside_lighting = {Slot::discard_fragment, Slot::modify_shaded};

/// Whether lighting is computed per vertex. Not if a feature changes the surface per pixel, since that would be lost.
bool lit_per_vertex(const SurfaceKey& key) {
  return key.structure.contains("PER_VERTEX") && key.output == "colour" && shading_code(key) &&
         codes_for(Slot::displace_texcoord, key).empty() && codes_for(Slot::modify_surface, key).empty();
}

/// Declares `shaded` as the light from `surface`. If no feature shades, it is a flat grey.
std::string lighting_statements(const SurfaceKey& key) {
  const auto shade = shading_code(key);
  return fmt::format("  vec3 shaded = {};\n", shade ? shade->function + "(surface)" : "vec3(0.5)") +
         calls(Slot::indirect, key, "  shaded += {}(surface);\n");
}

constexpr const char* surface_statement =
    "  Surface surface;\n"
    "  surface.position_world = v_position_world;\n"
    "  surface.normal_world = v_normal_world;\n"
    "  surface.texcoord = v_texcoord;\n"
    "  surface.eye_world = u_eye_world;\n"
    "#ifdef TANGENTS\n"
    "  surface.tangent_world = v_tangent_world;\n"
    "#endif\n"
    "#ifdef FRAGMENT_DEPTH\n"
    "  surface.depth = gl_FragCoord.z;\n"
    "#endif\n";

/// The constants that are passed to the fragment stage as varyings. Drivers may use four components for each varying,
/// whatever its type.
std::vector<DrawConstant> passed_constants(const SurfaceKey& key, int varyings) {
  if (!key.structure.contains(constants_as_varyings) || lit_per_vertex(key)) return {};
  std::vector<DrawConstant> constants = {{"vec3", "u_eye_world"}};
  for (const Feature* feature : key.features)
    for (DrawConstant& constant : feature->draw_constants()) constants.push_back(std::move(constant));
  const int taken = 4 + int(key.structure.count("TANGENTS") + key.structure.count("CLIP_PLANE") +
                            key.structure.count("KEPT"));  // with gl_Position
  return constants_that_fit(constants, key.structure, varyings / 4 * 4 - 4 * taken);
}

/// Transforms a vertex with step 01's functions; Gouraud shading also lights it here.
std::string vertex_stage(const std::string& transforms_glsl, const SurfaceKey& key, const PassedConstants& constants) {
  const bool lights = lit_per_vertex(key), clips = key.structure.contains("CLIP_PLANE");
  const bool tangents = key.structure.contains("TANGENTS");
  std::string text = vertex_text + include_line(transforms_glsl);
  if (tangents)
    text += "layout(location = 3) in vec4 a_tangent;\nuniform bool u_mirrored;\nout vec4 v_tangent_world;\n";
  const bool ends = key.structure.contains("KEPT");
  if (clips) text += "uniform vec4 u_clip_plane;\n";
  if (ends) text += "uniform vec4 u_kept;\n";
  if (lights) text += "out vec3 v_shaded;\n" + features_text(key, lighting_slots);
  text += constants.vertex_declarations;
  text +=
      "void main() {\n"
      "  v_position_world = world_position(u_model, a_position);\n"
      "  v_normal_world = world_normal(u_normal_matrix, a_normal);\n"
      "  v_texcoord = a_texcoord;\n"
      "  gl_Position = clip_position(u_projection, u_view, u_model, a_position);\n";
  // A tangent is transformed by the model matrix, like differences of positions. A mirroring matrix exchanges the sides
  // of the surface.
  if (tangents)
    text +=
        "  vec3 tangent = mat3(u_model) * a_tangent.xyz;\n"
        "  float size = length(tangent);\n"
        "  v_tangent_world = vec4(size > 0.0 ? tangent / size : vec3(0.0), u_mirrored ? -a_tangent.w : a_tangent.w);\n";
  if (clips) text += "  gl_ClipDistance[0] = dot(u_clip_plane, vec4(v_position_world, 1.0));\n";
  if (ends) text += "  gl_ClipDistance[1] = dot(u_kept, vec4(v_position_world, 1.0));\n";
  if (lights) text += surface_statement + lighting_statements(key) + "  v_shaded = shaded;\n";
  return text + constants.vertex_statements + "}\n";
}

/// Builds the surface, lets the features change and shade it, and writes the output.
std::string fragment_stage(const SurfaceKey& key, const PassedConstants& constants) {
  std::string text = constants.fragment_declarations + fragment_text;
  const bool lit = lit_per_vertex(key);
  if (lit) text += "in vec3 v_shaded;\n";
  if (key.structure.contains("TANGENTS")) text += "in vec4 v_tangent_world;\n";
  text += lit ? features_text(key, slots_beside_lighting) : features_text(key, all_slots);
  text += fmt::format(
      "void main() {{\n{}"
      "#ifdef TWO_SIDED\n"
      "  if (!gl_FrontFacing) surface.normal_world = -surface.normal_world;\n"
      "#endif\n",
      surface_statement);
  text +=
      calls(Slot::displace_texcoord, key, "  {}(surface);\n") + calls(Slot::modify_surface, key, "  {}(surface);\n");
  text += calls(Slot::discard_fragment, key, "  if ({}(surface)) discard;\n");
  const std::string output = output_expression(key);
  if (output.find("shaded") != std::string::npos) {
    text += lit ? "  vec3 shaded = v_shaded;\n" : lighting_statements(key);
    text += calls(Slot::modify_shaded, key, "  shaded = {}(surface, shaded);\n");
  }
  text += fmt::format("  o_colour = vec4({}, 1.0);\n", output);
  if (key.structure.contains("FRAGMENT_DEPTH")) text += "  gl_FragDepth = surface.depth;\n";
  if (key.structure.contains(marks_non_finite))
    text += "  if (any(isnan(o_colour)) || any(isinf(o_colour))) o_colour = vec4(1.0, 0.0, 1.0, 1.0);\n";
  return text + "}\n";
}

}  // namespace

SurfaceSources assemble_surface(const FindFile& find, const std::string& transforms_glsl, const SurfaceKey& key,
                                int varyings) {
  const PassedConstants constants = pass_as_varyings(passed_constants(key, varyings), key.structure, vertex_text);
  Defines structure = key.structure;
  if (knows_visibility(key)) structure["VISIBILITY"] = "1";
  // The vertex stage gets the defines only if it lights: all other variants share one text, which the driver compiles
  // once (Mesa caches by the text's hash).
  SurfaceSources sources{
      assemble_shader_text(find, vertex_stage(transforms_glsl, key, constants), "surface vertex shader",
                           lit_per_vertex(key) ? structure : Defines{}),
      assemble_shader_text(find, fragment_stage(key, constants), "surface fragment shader", structure)};
  make_global(sources.fragment, constants);
  return sources;
}

}  // namespace atelier
