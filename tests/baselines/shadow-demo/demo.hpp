// The demos of LearnOpenGL's two chapters on shadows (Joey de Vries, learnopengl.com: "Shadow Mapping" and "Point
// Shadows"), written anew from what they say: the same maps, boxes, biases and filters, and the same few calls. They
// are what many programs begin with, and so what a better one is compared with.
//
// What differs from the chapters is what must not tell in a comparison: target and texture have the formats that the
// settings name, those of the step's own (8 bits hold sRGB codes, where the chapters take codes for light), the formula
// of the light's reflection (step 02's) and, under the sun, the light's direction are those of the step's own scene.
// Where the chapters waste time by the way (they clear the picture twice and ask for each uniform's place in each
// frame), the demos do not.
#pragma once

#include <memory>
#include <string>

#include "app/step_program.hpp"

namespace atelier::shadow_demo {

inline constexpr const char* name = "shadow-demo";

class Demo {
 public:
  virtual ~Demo() = default;
  virtual const Scene& scene() const = 0;
  /// The map, then the picture: its colour, or with `shadow_factor` the share of the light that arrives.
  virtual void draw(const Frame& frame, bool shadow_factor) = 0;
};

/// Scene "cubes": one map of parallel light. With `compact_textures` the wood is stored in 8 bits.
std::unique_ptr<Demo> make_sun_demo(Gl& gl, bool compact_textures);

/// Scene "cube-room": a cube of maps round a lamp. The room's walls turn their front to the lamp here, where the
/// chapter draws the back of a box and turns its normals.
std::unique_ptr<Demo> make_point_demo(Gl& gl, bool compact_textures);

}  // namespace atelier::shadow_demo
