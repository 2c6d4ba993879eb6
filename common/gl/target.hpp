// Render targets, and how to read them back into an Image.
#pragma once

#include <cstddef>
#include <string>

#include "gl/objects.hpp"
#include "image/image.hpp"

namespace atelier {

/// srgb8 stores sRGB codes: the hardware encodes the linear light that a shader writes, and decodes what a sampler
/// reads. The other three store values as written, rgba8 clamped to 0..1.
enum class ColourFormat { none, rgba8, srgb8, rgba16f, rgba32f };
enum class DepthFormat { none, depth16, depth24, depth32f, depth24_stencil8, depth32f_stencil8 };

struct TargetSpec {
  int width = 1, height = 1;  ///< pixels, 1..16384
  ColourFormat colour = ColourFormat::rgba32f;
  DepthFormat depth = DepthFormat::depth24;
  int samples = 1;  ///< per pixel; 1..GL_MAX_SAMPLES, which is 4 or more; above 1: multisampling
  bool operator==(const TargetSpec&) const = default;
};

GLenum internal_format(ColourFormat format);  ///< OpenGL's name of it: GL_RGBA32F ...

bool has_stencil(const TargetSpec& spec);

/// "640x480, colour rgba32f, depth depth24"; if multisampled, also ", 4 samples".
std::string to_string(const TargetSpec& spec);

/// Nominal size of all attachments together; with multisampling, of the samples and of the textures that they are
/// resolved into.
std::size_t bytes(const TargetSpec& spec);

/// The longest side in pixels of a target with this many samples on this driver.
int longest_side(const Gl& gl, int samples = 1);

/// The most samples per pixel of a target on this driver; OpenGL 3.3 guarantees at least 4.
int most_samples(const Gl& gl);

/// A framebuffer with a colour texture (nearest filtering, clamped) and a depth texture as given by `spec`. With
/// several samples, drawing goes into multisampled renderbuffers, and the textures hold the result after `resolve`. The
/// constructor throws Error naming the size, the formats and the samples if they are out of range or the driver rejects
/// them. Constructing, resolving, reading and destroying a target do not change the bindings of textures, renderbuffers
/// and framebuffers.
class Target {
 public:
  Target(Gl& gl, const TargetSpec& spec);

  /// A face of a cube map that another object owns; it has the spec's colour format and its size, which is square.
  struct CubeFace {
    GLuint texture = 0;
    int face = 0;  ///< +x, -x, +y, -y, +z, -z
  };
  /// The same with that face as its colour texture.
  Target(Gl& gl, const TargetSpec& spec, const CubeFace& face);

  const TargetSpec& spec() const { return spec_; }
  GLuint framebuffer() const { return framebuffer_.id(); }  ///< the one to draw into
  GLuint colour_texture() const { return colour_.id(); }    ///< 0 if it owns none
  GLuint depth_texture() const { return depth_.id(); }      ///< 0 if there is none

  /// Binds it for drawing, sets the viewport to all of it, and enables GL_FRAMEBUFFER_SRGB if the colour format is
  /// srgb8, else disables it.
  void bind(Gl& gl) const;

  /// Resolves the samples into the textures; call it at the end of every frame. Does nothing with one sample. A pixel's
  /// colour becomes the mean of its samples, in linear light. Its depth becomes that of one sample, which the driver
  /// chooses (glBlitFramebuffer with GL_NEAREST): a mean of depths would lie between surfaces.
  void resolve(Gl& gl) const;

  /// Resolves, and reads the colour as floats, flipped so that row 0 is the top. NaN and infinity are kept. srgb8 is
  /// decoded to linear light. Throws Error if it has no colour.
  Image read_colour(Gl& gl) const;
  /// Resolves, and reads depth 0..1 in red, green and blue, row 0 at the top. Throws Error if it has no depth.
  Image read_depth(Gl& gl) const;

 private:
  Target(Gl& gl, const TargetSpec& spec, const CubeFace* face);
  GLuint textures_framebuffer() const { return resolved_ ? resolved_.id() : framebuffer_.id(); }

  TargetSpec spec_;
  GlTexture colour_, depth_;
  GlRenderbuffer colour_samples_, depth_samples_;  ///< empty with one sample
  GlFramebuffer framebuffer_, resolved_;           ///< with several samples, resolved_ has the textures
};

}  // namespace atelier
