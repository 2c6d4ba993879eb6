// The default state, from which every view, pass and probe starts.
#include "gl/state.hpp"

#include <array>

#include "catch.hpp"
#include "contexts.hpp"
#include "gl/query.hpp"
#include "gl/shader.hpp"

namespace {

using namespace atelier;

/// All that can be read back of what reset_state sets, under names.
std::map<std::string, std::vector<double>> state_of(Gl& gl) {
  std::map<std::string, std::vector<double>> state;
  const auto integers = [&](const char* name, GLenum what, int count = 1) {
    std::array<GLint, 4> values{};
    gl.GetIntegerv(what, values.data());
    state[name].assign(values.begin(), values.begin() + count);
  };
  const auto floats = [&](const char* name, GLenum what, int count) {
    std::array<GLfloat, 4> values{};
    gl.GetFloatv(what, values.data());
    state[name].assign(values.begin(), values.begin() + count);
  };
  for (const auto& [name, what] : std::map<const char*, GLenum>{{"depth test", GL_DEPTH_TEST},
                                                                {"stencil test", GL_STENCIL_TEST},
                                                                {"scissor test", GL_SCISSOR_TEST},
                                                                {"depth clamp", GL_DEPTH_CLAMP},
                                                                {"cull face", GL_CULL_FACE},
                                                                {"polygon offset", GL_POLYGON_OFFSET_FILL},
                                                                {"blend", GL_BLEND},
                                                                {"sRGB", GL_FRAMEBUFFER_SRGB},
                                                                {"clip distance 0", GL_CLIP_DISTANCE0},
                                                                {"clip distance 5", GL_CLIP_DISTANCE0 + 5}})
    state[name] = {double(gl.IsEnabled(what))};
  integers("depth function", GL_DEPTH_FUNC);
  integers("depth mask", GL_DEPTH_WRITEMASK);
  floats("depth range", GL_DEPTH_RANGE, 2);
  floats("clear depth", GL_DEPTH_CLEAR_VALUE, 1);
  integers("stencil function", GL_STENCIL_FUNC);
  integers("stencil fail", GL_STENCIL_FAIL);
  integers("stencil depth fail", GL_STENCIL_PASS_DEPTH_FAIL);
  integers("stencil pass", GL_STENCIL_PASS_DEPTH_PASS);
  integers("clear stencil", GL_STENCIL_CLEAR_VALUE);
  integers("culled face", GL_CULL_FACE_MODE);
  integers("front face", GL_FRONT_FACE);
  integers("colour mask", GL_COLOR_WRITEMASK, 4);
  floats("clear colour", GL_COLOR_CLEAR_VALUE, 4);
  integers("program", GL_CURRENT_PROGRAM);
  integers("vertex array", GL_VERTEX_ARRAY_BINDING);
  integers("texture unit", GL_ACTIVE_TEXTURE);
  if (gl.ClipControl.call) {
    integers("clip origin", GL_CLIP_ORIGIN);
    integers("clip depths", GL_CLIP_DEPTH_MODE);
  }
  std::array<GLint, 2> modes{};  // core contexts answer one, others two
  gl.GetIntegerv(GL_POLYGON_MODE, modes.data());
  state["polygon mode"] = {double(modes[0])};
  // Masks of 8 bits or more: what a driver has beyond them differs.
  for (const auto& [name, what] : std::map<const char*, GLenum>{{"stencil mask", GL_STENCIL_WRITEMASK},
                                                                {"stencil value mask", GL_STENCIL_VALUE_MASK}})
    state[name] = {double(integer_of(gl, what) & 0xff)};
  return state;
}

/// As untidy as functions may be that nobody has seen yet.
void disorder(Gl& gl, GLuint vertex_array, GLuint program) {
  gl.UseProgram(program);
  if (gl.ClipControl.call) gl.ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
  for (const GLenum what :
       {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_SCISSOR_TEST, GL_DEPTH_CLAMP, GL_CULL_FACE, GL_POLYGON_OFFSET_FILL, GL_BLEND,
        GL_FRAMEBUFFER_SRGB, GL_CLIP_DISTANCE0, GL_CLIP_DISTANCE0 + 5})
    gl.Enable(GLenum(what));
  gl.DepthFunc(GL_NEVER);
  gl.DepthMask(GL_FALSE);
  gl.DepthRange(0.5, 0.25);
  gl.ClearDepth(0.25);
  gl.StencilFunc(GL_LESS, 3, 0x0f);
  gl.StencilOp(GL_INCR, GL_DECR, GL_ZERO);
  gl.StencilMask(0x01);
  gl.ClearStencil(7);
  gl.CullFace(GL_FRONT);
  gl.FrontFace(GL_CW);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  gl.ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
  gl.ClearColor(1, 0.5f, 0.25f, 1);
  gl.BindVertexArray(vertex_array);
  gl.ActiveTexture(GL_TEXTURE3);
}

}  // namespace

TEST_CASE("drawing starts from default state, whatever a function has changed", "[state]") {
  const auto context = make_headless_context();
  Gl& gl = context->gl();
  const auto fresh = state_of(gl);
  const GlVertexArray vertex_array(gl);
  const auto stage = [](const std::string& text) {
    return assemble_shader_text([](const std::string&) { return std::filesystem::path(); }, text, "state", {});
  };
  const GlProgram program = build_program(gl, stage("void main() { gl_Position = vec4(0.0); }\n"),
                                          stage("out vec4 o; void main() { o = vec4(0.0); }\n"));
  disorder(gl, vertex_array.id(), program.id());
  const auto left = state_of(gl);
  for (const auto& [name, values] : fresh) {
    INFO(name);
    CHECK(left.at(name) != values);  // or the test would not see it
  }
  reset_state(gl);
  for (const auto& [name, values] : fresh) {
    INFO(name);
    CHECK(state_of(gl).at(name) == values);
  }
  check_gl_error(gl, "resetting the state");
}
