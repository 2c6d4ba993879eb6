// What both demos do in a frame: everything into a map of depths, then the picture.
#pragma once

#include "demo/program.hpp"
#include "shadow-demo/demo.hpp"
#include "shadow-demo/demo_scene.hpp"
#include "shadow-demo/lit_shaders.hpp"

namespace atelier::shadow_demo {

/// A depth texture of so many texels a side, and how it is bound.
struct DepthMap {
  GLenum target;
  int resolution;
  GlTexture texture;
};

class TwoPassDemo : public Demo {
 public:
  const Scene& scene() const override { return demo_.scene(); }
  void draw(const Frame& frame, bool shadow_factor) override;

 protected:
  /// `depth` draws into the map, all of its layers at once; `lit_vertex` and `shadow` as in lit_shaders.hpp.
  TwoPassDemo(Gl& gl, DemoScene scene, DepthMap map, demo::Program depth, const std::string& lit_vertex,
              const std::string& shadow);

 private:
  /// Sets what the light has of the program in use: of the depth pass, and of the picture.
  virtual void set_depth_light(Uniforms& uniforms) = 0;
  virtual void set_light(Uniforms& uniforms) = 0;

  void draw_map();
  void begin_picture(const Frame& frame);
  void set_common(demo::Program& program, const Frame& frame);

  Gl& gl_;
  DemoScene demo_;
  DepthMap map_;
  demo::Program depth_, colour_, factor_;
  GlFramebuffer framebuffer_;
};

}  // namespace atelier::shadow_demo
