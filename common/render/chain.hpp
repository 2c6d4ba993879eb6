// Post-processing: a chain of passes, each of which computes a picture from pictures.
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

/// A picture of 8 bits per channel: red, green, blue, alpha; row 0 on top; colours encoded to sRGB.
struct ByteImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Additional outputs that a CPU pass reads, by name.
using PassInputs = std::map<std::string, Image>;

/// One pass: a shader or a CPU function.
struct ChainPass {
  std::string name;                ///< its output: the chain's result after this pass
  std::vector<std::string> reads;  ///< additional outputs of the view ("depth", "normal"), drawn only if listed;
                                   ///< "colour" is the scene before the first pass
  bool identity = false;           ///< changes no pixel, so it is skipped
  bool begins = false;             ///< a shader that takes the scene's place: reads neither u_picture nor "colour", so
                                   ///< that the scene and the passes before it are not drawn
  bool smooth = false;             ///< u_picture is filtered linearly, not by its nearest texel

  // For a shader: GLSL `vec4 f(vec2 texcoord)`, called for each pixel; (0,0) is the picture's lower left corner. It may
  // read u_picture, the result of the previous pass; u_NAME for each of `reads`; u_size, pixels (vec2).
  // STORED_IN_8_BITS is defined if its result is stored in 8 bits a channel.
  SlotCode code;
  Defines structure;                       ///< #defines
  std::function<void(Binder&)> bind = {};  ///< sets its own uniforms

  // For a CPU function, in place: on linear floats, or on 8-bit codes (which clamp to 0..1).
  std::function<void(Image& picture, const PassInputs& inputs)> on_floats = {};
  std::function<void(ByteImage& picture, const PassInputs& inputs)> on_bytes = {};
};

/// The functions of step 08 that the renderer calls.
struct ChainFunctions {
  /// A chain alternates between two targets. Returns the target, 0 or 1, of a pass that reads `source`; -1 is the
  /// scene's own target.
  int (*next_target)(int source) = nullptr;
  /// Draws one triangle that covers every pixel, with the program in use: corners 0, 1, 2, and no attributes.
  void (*draw_full_screen)(Gl& gl) = nullptr;
  std::string glsl;  ///< the include that defines vec2 full_screen_corner(int corner): clip space
};

}  // namespace atelier
