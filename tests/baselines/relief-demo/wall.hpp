// The wall of LearnOpenGL's chapters "Normal Mapping" and "Parallax Mapping" (Joey de Vries, learnopengl.com), written
// anew from what they say: one rectangle whose triangles have tangents of their own, light computed in tangent space;
// in the second chapter a depth map, followed in 8 to 32 layers by the angle of the view, with the last step
// interpolated.
//
// What differs from the chapters is what must not tell in a comparison: scene, camera and the formula of the light's
// reflection are those of the steps, targets and maps have the formats that the settings name, and colours are decoded
// from sRGB.
#pragma once

#include <string>

#include "app/step_program.hpp"
#include "demo/program.hpp"

namespace atelier::relief_demo {

struct MapFormats {
  bool compact_colours = false;  ///< 8 bits instead of floats, as sRGB codes
  bool compact_maps = false;     ///< of normals and depths: 8 bits instead of floats
  bool operator==(const MapFormats&) const = default;
};

class Wall {
 public:
  /// `scene` has one node, a rectangle with normals and heights, and one point light. With `depth`, the relief's as a
  /// fraction of the texture's side, its heights are followed; what leaves the texture is discarded.
  Wall(Gl& gl, Scene scene, double depth, MapFormats formats);

  const Scene& scene() const { return scene_; }
  /// `output`: colour, normal or texcoord.
  void draw(const Frame& frame);

 private:
  demo::Program& program(const std::string& output);
  void set_uniforms(Uniforms& uniforms, const Frame& frame) const;

  Gl& gl_;
  Scene scene_;
  float depth_;
  GlVertexArray vertex_array_;
  GlBuffer corners_;
  GLsizei count_ = 0;
  GlTexture colours_, normals_, depths_;
  std::map<std::string, demo::Program> programs_;  ///< by output
};

}  // namespace atelier::relief_demo
