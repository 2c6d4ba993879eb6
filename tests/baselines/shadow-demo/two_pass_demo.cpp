#include "shadow-demo/two_pass_demo.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace atelier::shadow_demo {

TwoPassDemo::TwoPassDemo(Gl& gl, DemoScene scene, DepthMap map, demo::Program depth, const std::string& lit_vertex,
                         const std::string& shadow)
    : gl_(gl),
      demo_(std::move(scene)),
      map_(std::move(map)),
      depth_(std::move(depth)),
      colour_(demo::build(gl, name, lit_vertex, lit_fragment(shadow, false))),
      factor_(demo::build(gl, name, lit_vertex, lit_fragment(shadow, true))),
      framebuffer_(gl) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl.FramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, map_.texture.id(), 0);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  check_gl_error(gl, "making the demo's map of depths");
}

void TwoPassDemo::draw_map() {
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_LESS);
  gl_.Viewport(0, 0, map_.resolution, map_.resolution);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  gl_.UseProgram(depth_.program.id());
  set_depth_light(depth_.uniforms);
  demo_.draw(gl_, depth_.uniforms);
}

/// Binds the frame's target and clears it: to the scene's background, or where no colours are drawn to black.
void TwoPassDemo::begin_picture(const Frame& frame) {
  frame.target.bind(gl_);
  const glm::vec3 background = frame.output == "colour" ? scene().background : glm::vec3(0);
  gl_.ClearColor(background.r, background.g, background.b, 1);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

/// Takes the program in use and sets all that belongs neither to a node nor to the light's place: camera, the light's
/// colour, material, textures (unit 0 the wood, 1 the map).
void TwoPassDemo::set_common(demo::Program& program, const Frame& frame) {
  const Camera& camera = frame.camera;
  const TargetSpec& size = frame.target.spec();
  const glm::vec3 eye(camera.eye), target(camera.target);
  const Material& material = demo_.material();
  Uniforms& uniforms = program.uniforms;
  gl_.UseProgram(program.program.id());
  uniforms.set("u_projection",
               glm::perspective(camera.fov_y, float(size.width) / float(size.height), camera.near, camera.far));
  uniforms.set("u_view", glm::lookAt(eye, target, camera.up));
  uniforms.set("u_eye", eye);
  uniforms.set("u_ambient", scene().ambient);
  uniforms.set("u_light_colour", scene().lights.front().colour);
  uniforms.set("u_diffuse", material.diffuse);
  uniforms.set("u_specular", material.specular);
  uniforms.set("u_exponent", material.exponent);
  uniforms.set("u_wood", 0);
  uniforms.set("u_map", 1);
  gl_.ActiveTexture(GL_TEXTURE1);
  gl_.BindTexture(map_.target, map_.texture.id());
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, demo_.texture());
}

void TwoPassDemo::draw(const Frame& frame, bool shadow_factor) {
  draw_map();
  begin_picture(frame);
  demo::Program& program = shadow_factor ? factor_ : colour_;
  set_common(program, frame);
  set_light(program.uniforms);
  demo_.draw(gl_, program.uniforms);
  check_gl_error(gl_, "drawing the demo");
}

}  // namespace atelier::shadow_demo
