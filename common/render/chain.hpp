// What happens to a picture after the scene is drawn: a list of passes, each of which makes a picture of pictures.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "gl/gl.hpp"
#include "image/image.hpp"
#include "render/binder.hpp"
#include "render/slots.hpp"

namespace atelier {

/// A picture of 8 bits a channel: red, green, blue, alpha; row 0 on top; colours encoded to sRGB.
struct ByteImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Outputs that a pass of the CPU reads beside the picture, by name.
using PassInputs = std::map<std::string, Image>;

/// One pass: a shader, or a function of the CPU.
struct ChainPass {
  std::string name;                ///< its output: what the chain has made up to here
  std::vector<std::string> reads;  ///< outputs of the view beside the picture ("depth", "normal"): drawn only then;
                                   ///< "colour" is what the scene itself was before the first pass
  bool identity = false;           ///< changes no pixel: it is not run

  // As a shader: GLSL `vec4 f(vec2 texcoord)`, called for each pixel; (0,0) is the picture's lower left corner. It may
  // read u_picture, what the pass before it has made; u_NAME for each of `reads`; u_size, pixels (vec2).
  SlotCode code;
  Defines structure;                       ///< #defines
  std::function<void(Binder&)> bind = {};  ///< sets its own uniforms

  // Or as a function of the CPU, in place: on linear floats, or on 8-bit codes (which clamp to 0..1).
  std::function<void(Image& picture, const PassInputs& inputs)> on_floats = {};
  std::function<void(ByteImage& picture, const PassInputs& inputs)> on_bytes = {};
};

/// What a step teaches of chains, as the renderer calls it.
struct ChainFunctions {
  /// A chain draws into two targets by turns. Which of them, 0 or 1, is drawn into by a pass that reads `source`; -1:
  /// it reads the scene's own.
  int (*next_target)(int source) = nullptr;
  /// Draws one triangle that covers every pixel, with the program in use: corners 0, 1, 2, and no attributes.
  void (*draw_full_screen)(Gl& gl) = nullptr;
  std::string glsl;  ///< the include that defines vec2 full_screen_corner(int corner): clip space
};

}  // namespace atelier
