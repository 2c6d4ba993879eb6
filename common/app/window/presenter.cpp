#include "app/window/presenter.hpp"

#include "gl/debug.hpp"
#include "gl/full_screen.hpp"
#include "gl/shader.hpp"
#include "gl/state.hpp"

namespace atelier {
namespace {

constexpr const char* fragment_text = R"(
in vec2 v_texcoord;
uniform sampler2D u_picture;
uniform bool u_encode;
out vec4 o_colour;

vec3 srgb_encode(vec3 linear) {
  return mix(1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, 12.92 * linear, lessThanEqual(linear, vec3(0.0031308)));
}

void main() {
  vec3 colour = texture(u_picture, v_texcoord).rgb;
  if (any(isnan(colour)) || any(isinf(colour))) {
    o_colour = vec4(1.0, 0.0, 1.0, 1.0);
    return;
  }
  colour = clamp(colour, 0.0, 1.0);
  o_colour = vec4(u_encode ? srgb_encode(colour) : colour, 1.0);
}
)";

GlProgram build(Gl& gl) {
  const FindFile nothing = [](const std::string&) { return std::filesystem::path(); };
  return build_program(gl, assemble_shader_text(nothing, full_screen_vertex_text, "presenter, vertex shader", {}),
                       assemble_shader_text(nothing, fragment_text, "presenter, fragment shader", {}));
}

}  // namespace

Presenter::Presenter(Gl& gl) : gl_(gl), program_(build(gl)) {
  label(gl, GL_PROGRAM, program_.id(), "presenter");
}

void Presenter::draw(const Target& picture, Encoding encoding, const PixelArea& area) {
  const DebugGroup group(gl_, "picture to window");
  reset_state(gl_);  // also disables sRGB conversion: the shader encodes, and some windows would encode again
  gl_.Viewport(area.corner.x, area.corner.y, area.size.x, area.size.y);
  gl_.UseProgram(program_.id());
  gl_.Uniform1i(gl_.GetUniformLocation(program_.id(), "u_picture"), 0);
  gl_.Uniform1i(gl_.GetUniformLocation(program_.id(), "u_encode"), encoding == Encoding::linear);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, picture.colour_texture());
  draw_triangle_by_id(gl_);
  gl_.BindTexture(GL_TEXTURE_2D, 0);
}

Image read_framebuffer(Gl& gl, glm::ivec2 size) {
  Image image(size.x, size.y);
  std::vector<Rgba> row(std::size_t(size.x) * size.y);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, row.data());
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) image.at(x, y) = row[std::size_t(size.y - 1 - y) * size.x + x];
  return image;
}

}  // namespace atelier
