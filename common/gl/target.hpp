// A set of textures to draw into, and the way back to an Image.
#pragma once

#include <cstddef>
#include <string>

#include "gl/objects.hpp"
#include "image/image.hpp"

namespace atelier {

/// srgb8 holds sRGB codes: what a shader writes is linear light and is encoded by the hardware, what a sampler reads is
/// decoded by it. The three others hold what was written: rgba8 clamped to 0..1.
enum class ColourFormat { none, rgba8, srgb8, rgba16f, rgba32f };
enum class DepthFormat { none, depth16, depth24, depth32f, depth24_stencil8, depth32f_stencil8 };

struct TargetSpec {
  int width = 1, height = 1;  ///< pixels, 1..16384
  ColourFormat colour = ColourFormat::rgba32f;
  DepthFormat depth = DepthFormat::depth24;
  int samples = 1;  ///< a pixel; 1..GL_MAX_SAMPLES, which is 4 or more; above 1: multisampling
  bool operator==(const TargetSpec&) const = default;
};

GLenum internal_format(ColourFormat format);  ///< as OpenGL calls it: GL_RGBA32F ...

bool has_stencil(const TargetSpec& spec);

std::string to_string(const TargetSpec& spec);  ///< "640x480, colour rgba32f, depth depth24", ", 4 samples" if so

/// Of all attachments together, by the formats' nominal sizes; with several samples these are the samples and the
/// textures that they are resolved into.
std::size_t bytes(const TargetSpec& spec);

/// The longest side in pixels that a target with so many samples may have on this driver.
int longest_side(const Gl& gl, int samples = 1);

/// The most samples a pixel that a target may have on this driver: at least 4, unless it breaks OpenGL 3.3's promise.
int most_samples(const Gl& gl);

/// A framebuffer with a colour texture (nearest filtering, clamped) and a depth texture as `spec` asks. With several
/// samples, what is drawn goes into renderbuffers of that many, and the textures hold it after `resolve`. Whole when
/// made; throws Error naming the size, the formats and the samples where they are out of range or the driver refuses.
/// Making, resolving, reading and ending one leave the bindings of textures, renderbuffers and framebuffers as they
/// were.
class Target {
 public:
  Target(Gl& gl, const TargetSpec& spec);

  /// A side of a cube map that somebody else owns, of the spec's colour format and, square, of its size.
  struct CubeFace {
    GLuint texture = 0;
    int face = 0;  ///< +x, -x, +y, -y, +z, -z
  };
  /// The same with that side as its colour texture.
  Target(Gl& gl, const TargetSpec& spec, const CubeFace& face);

  const TargetSpec& spec() const { return spec_; }
  GLuint framebuffer() const { return framebuffer_.id(); }  ///< what is drawn into
  GLuint colour_texture() const { return colour_.id(); }    ///< 0 where there is none of its own
  GLuint depth_texture() const { return depth_.id(); }      ///< 0 where there is none

  /// Binds it for drawing, sets the viewport to all of it, and has OpenGL encode what is drawn (GL_FRAMEBUFFER_SRGB)
  /// where the colour is srgb8, and not encode it where it is another.
  void bind(Gl& gl) const;

  /// Brings the samples into the textures; every frame ends with it. Nothing happens where there is one sample. A
  /// pixel's colour becomes the mean of its samples, in linear light. Its depth becomes that of one of them, whichever
  /// the driver takes (glBlitFramebuffer with GL_NEAREST allows no more): a mean of depths would lie between surfaces,
  /// where nothing is.
  void resolve(Gl& gl) const;

  /// Resolves, and reads the colour as floats, turned so that row 0 is the top. NaN and infinity come through. srgb8 is
  /// decoded: linear light. Throws Error where it has none.
  Image read_colour(Gl& gl) const;
  /// Resolves, and reads depth 0..1 in red, green and blue, row 0 at the top. Throws Error where it has none.
  Image read_depth(Gl& gl) const;

 private:
  Target(Gl& gl, const TargetSpec& spec, const CubeFace* face);
  GLuint textures_framebuffer() const { return resolved_ ? resolved_.id() : framebuffer_.id(); }

  TargetSpec spec_;
  GlTexture colour_, depth_;
  GlRenderbuffer colour_samples_, depth_samples_;  ///< empty where there is one sample
  GlFramebuffer framebuffer_, resolved_;           ///< the latter has the textures where there are several samples
};

}  // namespace atelier
