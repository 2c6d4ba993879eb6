#include "03-shadow-mapping/given/map_picture.hpp"

#include <array>

#include "gl/full_screen.hpp"
#include "gl/state.hpp"

namespace atelier {

namespace {

/// Disables comparison and filtering of the bound texture during its lifetime.
class ReadAsStored {
 public:
  ReadAsStored(Gl& gl, GLenum kind) : gl_(gl), kind_(kind) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      gl.GetTexParameteriv(kind, names[i], &before_[i]);
      gl.TexParameteri(kind, names[i], names[i] == GL_TEXTURE_COMPARE_MODE ? GL_NONE : GL_NEAREST);
    }
  }
  ~ReadAsStored() {
    for (std::size_t i = 0; i < names.size(); ++i) gl_.TexParameteri(kind_, names[i], before_[i]);
  }
  ReadAsStored(const ReadAsStored&) = delete;
  ReadAsStored& operator=(const ReadAsStored&) = delete;

 private:
  static constexpr std::array<GLenum, 3> names{GL_TEXTURE_COMPARE_MODE, GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER};
  Gl& gl_;
  GLenum kind_;
  std::array<GLint, names.size()> before_{};
};

}  // namespace

void MapPicture::draw(Gl& gl, const Target& target, GLuint texture, const std::function<void(Uniforms&)>& bind) {
  if (!program_) {
    const FindFile no_includes = [](const std::string&) { return std::filesystem::path(); };
    const auto stage = [&](const std::string& text) {
      return assemble_shader_text(no_includes, text, "shadow map", {});
    };
    program_ = build_program(gl, stage(full_screen_vertex_text), stage(fragment_));
  }
  reset_state(gl);
  target.bind(gl);
  gl.UseProgram(program_.id());
  Uniforms uniforms(gl, program_.id());
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(kind_, texture);
  uniforms.set("u_map", 0);
  uniforms.set("u_size", glm::vec2(target.spec().width, target.spec().height));
  if (bind) bind(uniforms);
  {
    const ReadAsStored stored(gl, kind_);
    draw_triangle_by_id(gl);
  }
  gl.BindTexture(kind_, 0);
}

}  // namespace atelier
