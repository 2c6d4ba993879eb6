#include "07-stencil-portals/given/probes.hpp"

#include <array>

#include "07-stencil-portals/stencil_portals.hpp"
#include "gl/full_screen.hpp"
#include "gl/state.hpp"
#include "gl/target.hpp"

namespace atelier {

namespace {

using namespace stencil_portals;

// ---- Stencil

constexpr int columns = 8;  ///< of a picture one pixel high

/// What the buffers hold, column by column: two pixels of each kind, the first with a far surface in it (depth 0.75),
/// the second with a near one (0.25).
struct Buffers {
  std::array<GLint, columns> stencil{};
  std::array<float, columns> depth{0.75f, 0.25f, 0.75f, 0.25f, 0.75f, 0.25f, 0.75f, 0.25f};
};

void fill(Gl& gl, const Buffers& buffers) {
  gl.Enable(GL_SCISSOR_TEST);
  for (int x = 0; x < columns; ++x) {
    gl.Scissor(x, 0, 1, 1);
    gl.ClearStencil(buffers.stencil[std::size_t(x)]);
    gl.ClearDepth(double(buffers.depth[std::size_t(x)]));
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  }
  gl.Disable(GL_SCISSOR_TEST);
}

/// Calls `begin` on a picture whose stencil buffer holds these levels, draws an opening of depth 0.5 over all of it,
/// and returns what is in the stencil buffer, in the depth buffer, and the sum of the colour's four channels: 0 before,
/// 1 for each in which the opening's colour was written.
Numbers draw_opening(ProbeContext& context, const std::array<GLint, columns / 2>& levels, bool reversed,
                     const std::function<void()>& begin) {
  Gl& gl = context.gl;
  const Target target(gl, {.width = columns, .height = 1, .depth = DepthFormat::depth24_stencil8});
  const FindFile find = [&](const std::string& name) { return context.shaders.find(name); };
  const GlProgram program = build_program(
      gl, assemble_shader_text(find, full_screen_vertex_text, "probe vertex shader", {}),
      assemble_shader_text(find, "out vec4 o; void main() { o = vec4(1.0); }\n", "probe fragment shader", {}));
  reset_state(gl);
  target.bind(gl);
  Buffers buffers;
  for (std::size_t x = 0; x < columns; ++x) buffers.stencil[x] = levels[x / 2];
  fill(gl, buffers);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GLenum(reversed ? GL_GREATER : GL_LESS));
  gl.UseProgram(program.id());
  begin();
  draw_triangle_by_id(gl);
  reset_state(gl);
  target.bind(gl);
  std::array<std::uint8_t, columns> stencil{};
  std::array<float, columns> depth{};
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, columns, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil.data());
  gl.ReadPixels(0, 0, columns, 1, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  Numbers out;
  for (const std::uint8_t value : stencil) out.push_back(value);
  for (const float value : depth) out.push_back(double(value));
  const Image colour = target.read_colour(gl);
  for (const Rgba& p : colour.pixels()) out.push_back(double(p.r + p.g + p.b + p.a));
  return out;
}

Numbers probe_mark(ProbeContext& context, const Arguments& in) {
  const int level = in.integer("level");
  return draw_opening(context, {level, level + 1, level > 0 ? level - 1 : 7, level ^ 128}, in.number("reversed") > 0.5,
                      [&] { begin_mark(context.gl, level); });
}

Numbers probe_restore(ProbeContext& context, const Arguments& in) {
  const int level = in.integer("level");
  return draw_opening(context, {level, level + 1, level < 254 ? level + 2 : 9, (level + 1) ^ 128},
                      in.number("reversed") > 0.5, [&] { begin_restore(context.gl, level); });
}

// ---- Rectangles, visitors, clipping

/// "corners": x, y, z, w of each. Four numbers; -1 four times for none.
Numbers probe_rectangle(ProbeContext&, const Arguments& in) {
  const auto& flat = in.numbers("corners");
  std::vector<glm::vec4> corners;
  for (std::size_t i = 0; i + 4 <= flat.size(); i += 4)
    corners.emplace_back(flat[i], flat[i + 1], flat[i + 2], flat[i + 3]);
  const auto found = opening_rectangle(corners, glm::ivec2(in.vec2("size")), glm::ivec4(in.vec4("around")));
  return found ? numbers_of(*found) : Numbers{-1, -1, -1, -1};
}

Numbers probe_carried(ProbeContext&, const Arguments& in) {
  Camera camera{.eye = in.vec3("eye"), .target = in.vec3("target"), .up = glm::vec3(in.vec3("up"))};
  camera.fov_y = float(in.number("fov_y"));
  camera.near = 0.25f, camera.far = 50, camera.height = 7;
  const Camera after = carried(camera, in.mat4("passage"));
  Numbers out;
  for (const Numbers& part : {numbers_of(after.eye), numbers_of(after.target), numbers_of(after.up)}) append(out, part);
  append(out, Numbers{double(after.fov_y), double(after.near), double(after.far), double(after.projection),
                      double(after.height)});
  return out;
}

// ---- Light and bodies

/// "type": 0 point, 1 spot, 2 directional.
Numbers probe_light_image(ProbeContext&, const Arguments& in) {
  Light light{
      .type = std::array{LightType::point, LightType::spot, LightType::directional}.at(std::size_t(in.integer("type"))),
      .position = in.vec3("position"),
      .direction = glm::vec3(in.vec3("direction")),
      .colour = {3, 2, 1},
      .attenuation = {0.25f, 0.5f, 0.75f},
      .inner_angle = 0.25f,
      .outer_angle = 0.75f,
      .casts_shadow = false};
  const Light image = light_image(light, in.mat4("passage"));
  // What a type does not use may be anything.
  Numbers out = numbers_of(light.type == LightType::directional ? glm::dvec3(0) : image.position);
  append(out, numbers_of(light.type == LightType::point ? glm::vec3(0) : image.direction));
  out.push_back(double(image.type));
  append(out, numbers_of(image.colour));
  append(out, numbers_of(image.attenuation));
  append(out, Numbers{double(image.inner_angle), double(image.outer_angle), double(image.casts_shadow)});
  return out;
}

/// "corners": x, y, z of each of the eight.
Numbers probe_stands_in(ProbeContext&, const Arguments& in) {
  const auto& flat = in.numbers("corners");
  std::array<glm::dvec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = {flat.at(3 * i), flat.at(3 * i + 1), flat.at(3 * i + 2)};
  return {double(stands_in(in.mat4("frame_to_world"), in.vec2("half_size"), corners))};
}

}  // namespace

std::map<std::string, Probe> portal_probes() {
  const std::string glsl = text_including("07-stencil-portals/stencil_portals.glsl");
  return {
      {"portal_passage",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(portal_passage(in.mat4("entry_to_world"), in.mat4("exit_to_world")));
       }},
      {"mirror_passage",
       [](ProbeContext&, const Arguments& in) { return numbers_of(mirror_passage(in.mat4("mirror_to_world"))); }},
      {"virtual_view",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(virtual_view(glm::mat4(in.mat4("world_to_view")), in.mat4("passage")));
       }},
      {"opening_plane",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(opening_plane(in.mat4("frame_to_world"), in.number("from_behind") > 0.5));
       }},
      {"begin_mark", probe_mark},
      {"begin_restore", probe_restore},
      {"opening_rectangle", probe_rectangle},
      {"goes_through",
       [](ProbeContext&, const Arguments& in) {
         return Numbers{
             double(goes_through(in.mat4("frame_to_world"), in.vec2("half_size"), in.vec3("from"), in.vec3("to")))};
       }},
      {"carried", probe_carried},
      {"plane_in_view",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(plane_in_view(in.vec4("plane_world"), glm::mat4(in.mat4("world_to_view"))));
       }},
      {"oblique_projection",
       [](ProbeContext&, const Arguments& in) {
         return numbers_of(oblique_projection(glm::mat4(in.mat4("projection")), glm::vec4(in.vec4("plane_view"))));
       }},
      {"light_image", probe_light_image},
      {"stands_in", probe_stands_in},
      {"comes_out", shader_probe(glsl, "vec4(comes_out(position, to_light, world_to_exit, half_size) ? 1.0 : 0.0)", 1)},
      {"cut_away", shader_probe(glsl, "vec4(cut_away(position, plane) ? 1.0 : 0.0)", 1)},
  };
}

}  // namespace atelier
