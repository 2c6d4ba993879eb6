// 00-hello: one triangle. Do not change this file; it is short enough to read.
#include "app/frame_settings.hpp"
#include "app/step_program.hpp"
#include "gl/debug.hpp"
#include "gl/shader.hpp"

namespace atelier {

namespace {

constexpr const char* vertex_text = R"(
// No buffers yet: gl_VertexID selects one of the three corners.
const vec2 corners[3] = vec2[](vec2(-0.8, -0.7), vec2(0.8, -0.7), vec2(0.0, 0.8));
out vec3 v_weights;
void main() {
  v_weights = vec3(gl_VertexID == 0, gl_VertexID == 1, gl_VertexID == 2);
  gl_Position = vec4(corners[gl_VertexID], 0.0, 1.0);
}
)";

constexpr const char* fragment_text = R"(
#include "00-hello/hello.glsl"
in vec3 v_weights;
out vec4 o_colour;
void main() { o_colour = vec4(hello_colour(v_weights), 1.0); }
)";

class Hello : public StepProgram {
 public:
  const StepDescription& description() const override { return description_; }

  void open(Gl& gl, const Implementations& implementations) override {
    gl_ = &gl;
    implementations_ = implementations;
    vertex_array_ = GlVertexArray(gl);
  }

  void load(const std::string& scene, const Settings&) override {
    if (scene != "triangle") throw Error("scene '" + scene + "': 00-hello has one scene, triangle");
    if (program_.id() == 0) build();  // not in open(), so that a compile error counts for the case
  }

  Camera camera() const override { return {}; }

  void draw(const Frame& frame, const Settings&) override {
    const DebugGroup group(*gl_, "triangle");
    frame.target.bind(*gl_);
    gl_->ClearColor(0.02f, 0.02f, 0.03f, 1);
    gl_->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl_->UseProgram(program_.id());
    gl_->BindVertexArray(vertex_array_.id());
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
    check_gl_error(*gl_, "drawing the triangle");
  }

  std::string reload_changed_shaders() override {
    std::error_code gone;
    const auto now = std::filesystem::last_write_time(implementations_.find("00-hello/hello.glsl"), gone);
    if (gone || now == written_) return {};
    try {
      build();
    } catch (const Error& error) {
      written_ = now;
      return error.what();
    }
    return {};
  }

 private:
  void build() {
    const FindFile find = [this](const std::string& name) { return implementations_.find(name); };
    program_ = build_program(*gl_, assemble_shader_text(find, vertex_text, "vertex shader", {}),
                             assemble_shader_text(find, fragment_text, "fragment shader", {}));
    label(*gl_, GL_PROGRAM, program_.id(), "hello");
    written_ = std::filesystem::last_write_time(implementations_.find("00-hello/hello.glsl"));
  }

  StepDescription description_{.name = ATELIER_STEP,
                               .title = ATELIER_STEP_TITLE,
                               .camera = false,
                               .scenes = {"triangle"},
                               .settings = frame_settings(),
                               .outputs = {{"colour", Encoding::linear, "what is seen", Stage::colour}}};
  Gl* gl_ = nullptr;
  Implementations implementations_;
  GlVertexArray vertex_array_;
  GlProgram program_;
  std::filesystem::file_time_type written_;
};

}  // namespace

}  // namespace atelier

extern "C" atelier::StepProgram* atelier_step_program() {
  return new atelier::Hello;
}
