// 01-transforms: the program. Draws scenes with your matrices and your vertex buffers, with a placeholder for lighting.
#include "01-transforms/given/functions.hpp"
#include "01-transforms/given/preview.hpp"
#include "01-transforms/given/probes.hpp"
#include "01-transforms/given/scenes.hpp"
#include "01-transforms/given/truth.hpp"
#include "app/scene_program.hpp"
#include "gl/shader.hpp"
#include "gl/state.hpp"

namespace atelier {

namespace {

SceneStep transforms_step() {
  return {.name = ATELIER_STEP,
          .title = ATELIER_STEP_TITLE,
          .scenes = transform_scenes(),
          .settings = {view_settings(), transform_scene_settings()},
          .probes = transform_probes(),
          .transforms = transform_functions(),
          .features = [](FeatureList& list) { list.add<Preview>(); },
          .truth = transform_truth};
}

/// The renderer draws all scenes except "triangle", which uses upload_triangle.
class Transforms : public SceneProgram {
 public:
  Transforms() : SceneProgram(transforms_step()) {}

  void open(Gl& gl, const Implementations& implementations) override {
    SceneProgram::open(gl, implementations);
    gl_ = &gl;
  }

  void load(const std::string& scene, const Settings& settings) override {
    triangle_ = scene == "triangle";
    SceneProgram::load(scene, settings);
  }

  void draw(const Frame& frame, const Settings& settings) override {
    if (triangle_)
      draw_triangle(frame.target, settings.flag("draw.wireframe"));
    else
      SceneProgram::draw(frame, settings);
  }

 private:
  void draw_triangle(const Target& target, bool wireframe) {
    const FindFile no_includes = [](const std::string&) { return std::filesystem::path(); };
    const GlProgram program = build_program(
        *gl_,
        assemble_shader_text(no_includes, "layout(location = 0) in vec3 p; void main() { gl_Position = vec4(p, 1.0); }",
                             "triangle", {}),
        assemble_shader_text(no_includes, "out vec4 o; uniform vec3 u_colour; void main() { o = vec4(u_colour, 1.0); }",
                             "triangle", {}));
    const MeshBuffers made = transforms::upload_triangle(*gl_, triangle_corners);
    const GlVertexArray vertex_array(*gl_, made.vertex_array);
    const GlBuffer vertex_buffer(*gl_, made.vertex_buffer), index_buffer(*gl_, made.index_buffer);

    reset_state(*gl_);  // clear state left by the previous picture
    target.bind(*gl_);
    gl_->ClearColor(triangle_background.r, triangle_background.g, triangle_background.b, 1);
    gl_->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (!vertex_array) return;  // not written yet: nothing to draw
    transforms::set_wireframe(*gl_, wireframe);
    gl_->UseProgram(program.id());
    Uniforms(*gl_, program.id()).set("u_colour", triangle_colour);
    gl_->BindVertexArray(vertex_array.id());
    gl_->DrawArrays(GL_TRIANGLES, 0, made.count);
    gl_->BindVertexArray(0);
    transforms::set_wireframe(*gl_, false);
    check_gl_error(*gl_, "drawing the triangle");
  }

  Gl* gl_ = nullptr;
  bool triangle_ = false;
};

}  // namespace

}  // namespace atelier

extern "C" atelier::StepProgram* atelier_step_program() {
  return new atelier::Transforms;
}
