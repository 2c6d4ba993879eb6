#include "gl/target.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/error.hpp"
#include "gl/query.hpp"
#include "gl/texel.hpp"
#include "image/colour.hpp"

namespace atelier {
namespace {

/// A format's OpenGL constants.
struct FormatFacts {
  const char* name;
  GLenum internal, format, type, attachment;
};

constexpr std::array<FormatFacts, 5> colour_facts = {{
    {"none", GL_NONE, GL_NONE, GL_NONE, GL_NONE},
    {"rgba8", GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, GL_COLOR_ATTACHMENT0},
    {"srgb8", GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE, GL_COLOR_ATTACHMENT0},
    {"rgba16f", GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, GL_COLOR_ATTACHMENT0},
    {"rgba32f", GL_RGBA32F, GL_RGBA, GL_FLOAT, GL_COLOR_ATTACHMENT0},
}};

constexpr std::array<FormatFacts, 6> depth_facts = {{
    {"none", GL_NONE, GL_NONE, GL_NONE, GL_NONE},
    {"depth16", GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, GL_DEPTH_ATTACHMENT},
    {"depth24", GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, GL_DEPTH_ATTACHMENT},
    {"depth32f", GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, GL_DEPTH_ATTACHMENT},
    {"depth24_stencil8", GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, GL_DEPTH_STENCIL_ATTACHMENT},
    {"depth32f_stencil8", GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV,
     GL_DEPTH_STENCIL_ATTACHMENT},
}};

const FormatFacts& facts(ColourFormat format) {
  return colour_facts[std::size_t(format)];
}
const FormatFacts& facts(DepthFormat format) {
  return depth_facts[std::size_t(format)];
}

/// Saves the bindings, and restores them at the end of the scope.
class KeptBindings {
 public:
  explicit KeptBindings(Gl& gl)
      : gl_(gl),
        texture_(integer_of(gl, GL_TEXTURE_BINDING_2D)),
        renderbuffer_(integer_of(gl, GL_RENDERBUFFER_BINDING)),
        draw_(integer_of(gl, GL_DRAW_FRAMEBUFFER_BINDING)),
        read_(integer_of(gl, GL_READ_FRAMEBUFFER_BINDING)) {}
  ~KeptBindings() {
    gl_.BindTexture(GL_TEXTURE_2D, GLuint(texture_));
    gl_.BindRenderbuffer(GL_RENDERBUFFER, GLuint(renderbuffer_));
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(draw_));
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(read_));
  }
  KeptBindings(const KeptBindings&) = delete;
  KeptBindings& operator=(const KeptBindings&) = delete;

 private:
  Gl& gl_;
  GLint texture_, renderbuffer_, draw_, read_;
};

void switch_on(Gl& gl, GLenum capability, bool on) {
  if (on)
    gl.Enable(capability);
  else
    gl.Disable(capability);
}

/// Sets one of glEnable's capabilities, and restores it at the end of the scope.
class Switched {
 public:
  Switched(Gl& gl, GLenum capability, bool on) : gl_(gl), capability_(capability), was_(gl.IsEnabled(capability)) {
    switch_on(gl, capability, on);
  }
  ~Switched() { switch_on(gl_, capability_, was_); }
  Switched(const Switched&) = delete;
  Switched& operator=(const Switched&) = delete;

 private:
  Gl& gl_;
  GLenum capability_;
  bool was_;
};

/// Throws if such a target is outside the driver's limits. Checked first, because drivers differ in how they fail.
void check(Gl& gl, const TargetSpec& spec) {
  const int most = most_samples(gl);
  if (spec.samples < 1 || spec.samples > most)
    throw Error(fmt::format("target {}: samples must be 1..{} on this driver", to_string(spec), most));
  const int largest = longest_side(gl, spec.samples);
  if (spec.width < 1 || spec.height < 1 || spec.width > largest || spec.height > largest)
    throw Error(fmt::format("target {}: each side must be 1..{} pixels on this driver", to_string(spec), largest));
  if (spec.colour == ColourFormat::none && spec.depth == DepthFormat::none)
    throw Error(fmt::format("target {}: needs a colour or a depth", to_string(spec)));
}

GlTexture make_texture(Gl& gl, const FormatFacts& format, const TargetSpec& spec) {
  GlTexture texture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GLint(format.internal), spec.width, spec.height, 0, format.format, format.type,
                nullptr);
  return texture;
}

GlRenderbuffer make_samples(Gl& gl, const FormatFacts& format, const TargetSpec& spec) {
  GlRenderbuffer samples(gl);
  gl.BindRenderbuffer(GL_RENDERBUFFER, samples.id());
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, spec.samples, format.internal, spec.width, spec.height);
  return samples;
}

const char* incompleteness(GLenum status) {
  switch (status) {
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
      return "an attachment cannot be drawn to";
    case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
      return "an attachment is missing";
    case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE:
      return "the driver gives colour and depth different numbers of samples";
    case GL_FRAMEBUFFER_UNSUPPORTED:
      return "the driver does not support these formats together";
    default:
      return "the driver gives no reason";
  }
}

/// A framebuffer to which `attach`, called while it is bound, attaches images. Throws if the driver rejects it.
template <class Attach>
GlFramebuffer make_framebuffer(Gl& gl, const TargetSpec& spec, Attach attach) {
  GlFramebuffer framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  if (spec.colour == ColourFormat::none) {
    gl.DrawBuffer(GL_NONE);
    gl.ReadBuffer(GL_NONE);
  }
  attach();
  check_gl_error(gl, ("making a target of " + to_string(spec)).c_str());
  const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
    throw Error(fmt::format("target {}: {} (0x{:04x})", to_string(spec), incompleteness(status), status));
  return framebuffer;
}

/// Reads all pixels of the bound framebuffer, bottom row first, as in OpenGL. Rows of floats are multiples of four
/// bytes, so with an alignment of 4 there is no padding.
void read_pixels(Gl& gl, const TargetSpec& spec, GLenum format, void* destination) {
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, spec.width, spec.height, format, GL_FLOAT, destination);
}

/// From sRGB codes, as glReadPixels returns them (in steps of 1/255), to linear light.
void decode(Image& image) {
  const auto linear = [](float code) { return linear_of_code(std::uint8_t(code * 255 + 0.5f)); };
  for (Rgba& p : image.pixels()) p = {linear(p.r), linear(p.g), linear(p.b), p.a};
}

}  // namespace

std::string to_string(const TargetSpec& spec) {
  return fmt::format("{}x{}, colour {}, depth {}{}", spec.width, spec.height, facts(spec.colour).name,
                     facts(spec.depth).name, spec.samples == 1 ? "" : fmt::format(", {} samples", spec.samples));
}

bool has_stencil(const TargetSpec& spec) {
  return spec.depth == DepthFormat::depth24_stencil8 || spec.depth == DepthFormat::depth32f_stencil8;
}

GLenum internal_format(ColourFormat format) {
  return facts(format).internal;
}

std::size_t bytes(const TargetSpec& spec) {
  std::int64_t texel = 0;
  if (spec.colour != ColourFormat::none) texel += texel_bytes(facts(spec.colour).internal);
  if (spec.depth != DepthFormat::none) texel += texel_bytes(facts(spec.depth).internal);
  const std::int64_t stored = spec.samples > 1 ? spec.samples + 1 : 1;
  return std::size_t(spec.width) * std::size_t(spec.height) * std::size_t(texel * stored);
}

int longest_side(const Gl& gl, int samples) {
  const int longest = std::min(integer_of(gl, GL_MAX_TEXTURE_SIZE), Image::max_side);
  return samples > 1 ? std::min(longest, integer_of(gl, GL_MAX_RENDERBUFFER_SIZE)) : longest;
}

int most_samples(const Gl& gl) {
  return std::max(integer_of(gl, GL_MAX_SAMPLES), 1);
}

Target::Target(Gl& gl, const TargetSpec& spec) : Target(gl, spec, nullptr) {}
Target::Target(Gl& gl, const TargetSpec& spec, const CubeFace& face) : Target(gl, spec, &face) {}

Target::Target(Gl& gl, const TargetSpec& spec, const CubeFace* face) : spec_(spec) {
  check(gl, spec);
  check_gl_error(gl, "an earlier call, found before a target is created");
  const KeptBindings kept(gl);
  const auto attach_texture = [&](const FormatFacts& format, GlTexture& texture) {
    texture = make_texture(gl, format, spec);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, format.attachment, GL_TEXTURE_2D, texture.id(), 0);
  };
  framebuffer_ = make_framebuffer(gl, spec, [&] {
    if (face)
      gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face->face),
                              face->texture, 0);
    else if (spec.colour != ColourFormat::none)
      attach_texture(facts(spec.colour), colour_);
    if (spec.depth != DepthFormat::none) attach_texture(facts(spec.depth), depth_);
  });
  if (spec.samples == 1) return;
  resolved_ = std::move(framebuffer_);
  const auto attach_samples = [&](const FormatFacts& format, GlRenderbuffer& samples) {
    samples = make_samples(gl, format, spec);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, format.attachment, GL_RENDERBUFFER, samples.id());
  };
  framebuffer_ = make_framebuffer(gl, spec, [&] {
    if (spec.colour != ColourFormat::none) attach_samples(facts(spec.colour), colour_samples_);
    if (spec.depth != DepthFormat::none) attach_samples(facts(spec.depth), depth_samples_);
  });
}

void Target::bind(Gl& gl) const {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl.Viewport(0, 0, spec_.width, spec_.height);
  switch_on(gl, GL_FRAMEBUFFER_SRGB, spec_.colour == ColourFormat::srgb8);
}

void Target::resolve(Gl& gl) const {
  if (spec_.samples == 1) return;
  const KeptBindings kept(gl);
  const Switched whole(gl, GL_SCISSOR_TEST, false);  // the scissor test affects a blit
  // If enabled, sRGB codes are decoded before they are averaged, and the mean is encoded (OpenGL 4.4; earlier versions
  // specify a mean of codes, but drivers follow 4.4).
  const Switched linear(gl, GL_FRAMEBUFFER_SRGB, spec_.colour == ColourFormat::srgb8);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.id());
  GLbitfield planes = 0;
  if (spec_.colour != ColourFormat::none) planes |= GL_COLOR_BUFFER_BIT;
  if (spec_.depth != DepthFormat::none) planes |= GL_DEPTH_BUFFER_BIT;
  const GLint width = spec_.width, height = spec_.height;
  gl.BlitFramebuffer(0, 0, width, height, 0, 0, width, height, planes, GL_NEAREST);
  check_gl_error(gl, "resolving a target's samples");
}

Image Target::read_colour(Gl& gl) const {
  if (spec_.colour == ColourFormat::none) throw Error("target " + to_string(spec_) + ": has no colour to read");
  resolve(gl);
  const KeptBindings kept(gl);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, textures_framebuffer());
  static_assert(sizeof(Rgba) == 4 * sizeof(float), "pixels are read straight into the image");
  Image image(spec_.width, spec_.height);
  read_pixels(gl, spec_, GL_RGBA, image.pixels().data());
  check_gl_error(gl, "reading a target's colour");
  // Flip it in place: OpenGL's first row is the lowest.
  for (int top = 0, bottom = spec_.height - 1; top < bottom; ++top, --bottom)
    std::swap_ranges(&image.at(0, top), &image.at(0, top) + spec_.width, &image.at(0, bottom));
  if (spec_.colour == ColourFormat::srgb8) decode(image);
  return image;
}

Image Target::read_depth(Gl& gl) const {
  if (spec_.depth == DepthFormat::none) throw Error("target " + to_string(spec_) + ": has no depth to read");
  resolve(gl);
  const KeptBindings kept(gl);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, textures_framebuffer());
  std::vector<float> depths(std::size_t(spec_.width) * std::size_t(spec_.height));
  read_pixels(gl, spec_, GL_DEPTH_COMPONENT, depths.data());
  check_gl_error(gl, "reading a target's depth");
  Image image(spec_.width, spec_.height);
  const float* depth = depths.data();
  for (int y = spec_.height - 1; y >= 0; --y)
    for (int x = 0; x < spec_.width; ++x, ++depth) image.at(x, y) = {*depth, *depth, *depth, 1};
  return image;
}

}  // namespace atelier
