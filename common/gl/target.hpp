// A set of textures to draw into, and the way back to an Image.
#pragma once

#include <cstddef>
#include <string>

#include "gl/objects.hpp"
#include "image/image.hpp"

namespace atelier {

enum class ColourFormat { none, rgba8, rgba16f, rgba32f };
enum class DepthFormat { none, depth16, depth24, depth32f, depth24_stencil8, depth32f_stencil8 };

struct TargetSpec {
  int width = 1, height = 1;  ///< pixels, 1..16384
  ColourFormat colour = ColourFormat::rgba32f;
  DepthFormat depth = DepthFormat::depth24;
  bool operator==(const TargetSpec&) const = default;
};

std::string to_string(const TargetSpec& spec);  ///< "640x480, colour rgba32f, depth depth24"

std::size_t bytes(const TargetSpec& spec);  ///< of all attachments together, by the formats' nominal sizes

/// A framebuffer with a colour texture (nearest filtering, clamped) and a depth texture as `spec` asks. Whole when
/// made; throws Error naming the size and the formats where they are out of range or the driver refuses. Making one,
/// reading one and ending one leave the bindings of textures and framebuffers as they were.
class Target {
 public:
  Target(Gl& gl, const TargetSpec& spec);
  const TargetSpec& spec() const { return spec_; }
  GLuint framebuffer() const { return framebuffer_.id(); }
  GLuint colour_texture() const { return colour_.id(); }  ///< 0 where there is none
  GLuint depth_texture() const { return depth_.id(); }    ///< 0 where there is none

  /// Binds it for drawing and sets the viewport to all of it.
  void bind(Gl& gl) const;

  /// The colour as floats, turned so that row 0 is the top. NaN and infinity come through. Throws Error where it has
  /// none.
  Image read_colour(Gl& gl) const;
  /// Depth 0..1 in red, green and blue, row 0 at the top. Throws Error where it has none.
  Image read_depth(Gl& gl) const;

 private:
  TargetSpec spec_;
  GlTexture colour_, depth_;
  GlFramebuffer framebuffer_;
};

}  // namespace atelier
