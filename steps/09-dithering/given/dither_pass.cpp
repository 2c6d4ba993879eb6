#include "09-dithering/given/dither_pass.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "02-blinn-phong/given/shaders_alone.hpp"
#include "08-post-processing/given/post_chain.hpp"
#include "09-dithering/given/ordered_bytes.hpp"
#include "09-dithering/given/patterns.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "gl/debug.hpp"
#include "image/colour.hpp"

namespace atelier {

using namespace dithering;

std::vector<SettingSpec> dither_settings() {
  return {
      {.name = "dither.method",
       .fallback = std::string("none"),
       .choices = {"none", "rounded", "bayer", "blue-noise", "floyd-steinberg", "atkinson"},
       .help = "how few levels stand for many"},
      {.name = "dither.levels", .fallback = 2, .low = 2, .high = 256, .help = "of each channel"},
      {.name = "dither.grey", .fallback = false, .help = "dither the luma alone, for all channels"},
      {.name = "dither.space",
       .fallback = std::string("encoded"),
       .choices = {"encoded", "linear"},
       .help = "whether levels are even in sRGB codes or in light; the mean is kept in the same space"},
      {.name = "dither.matrix",
       .fallback = std::string("8"),
       .choices = {"2", "4", "8", "16"},
       .help = "Bayer's matrix: cells along each side"},
      {.name = "dither.serpentine", .fallback = false, .help = "every second row of diffused errors runs backwards"},
      {.name = "dither.fast",
       .fallback = false,
       .help = "on the CPU, many pixels at a time: floyd-steinberg without serpentine by diffused_fast, bayer on the "
               "screen; in codes alone, where it changes no pixel"},
      {.name = "dither.threads",
       .fallback = 2,
       .low = 1,
       .high = 4,
       .help = "channels whose errors are diffused at the same time; changes no pixel"},
      {.name = "dither.held",
       .fallback = std::string("screen"),
       .choices = {"screen", "sphere", "world"},
       .help = "to what the pattern of bayer and blue-noise is fixed"},
      {.name = "dither.cell",
       .fallback = 1.0,
       .low = 0.5,
       .high = 8,
       .help = "pixels: the cells of a pattern that is held by the sphere or the world (there up to twice as large)"},
      {.name = "dither.lines",
       .fallback = std::string("none"),
       .choices = {"none", "black", "white"},
       .help = "lines where surfaces end or bend"},
  };
}

std::vector<OutputSpec> dither_outputs() {
  std::vector<OutputSpec> outputs = post_outputs();
  outputs.push_back({"dither", Encoding::linear, "the picture after dithering, before lines", Stage::pass});
  outputs.push_back({"seen", Encoding::linear,
                     "the picture; its truth is what it stands for, without dithering and lines", Stage::after_colour});
  return outputs;
}

void DitherPass::configure(const Settings& settings) {
  method_ = settings.choice("dither.method");
  held_ = settings.choice("dither.held");
  lines_ = settings.choice("dither.lines");
  cell_ = float(settings.real("dither.cell"));
  diffusion_ = {.levels = settings.integer("dither.levels"),
                .kernel = method_ == "atkinson" ? Kernel::atkinson : Kernel::floyd_steinberg,
                .serpentine = settings.flag("dither.serpentine")};
  matrix_size_ = std::stoi(settings.choice("dither.matrix"));
  threads_ = settings.integer("dither.threads");
  linear_ = settings.choice("dither.space") == "linear";
  grey_ = settings.flag("dither.grey");
  const bool can_be_fast =
      method_ == "floyd-steinberg" ? !diffusion_.serpentine : method_ == "bayer" && held_ == "screen";
  fast_ = settings.flag("dither.fast") && can_be_fast && !linear_;
}

namespace {

/// Ranks as a texture of whole numbers in floats; row 0 is row 0 of the pattern.
GlTexture upload_ranks(Gl& gl, const std::vector<int>& ranks, int side, const char* function) {
  if (ranks.size() != std::size_t(side) * std::size_t(side))
    throw Error(fmt::format("{} returned {} ranks for a pattern of {} x {}", function, ranks.size(), side, side));
  const std::vector<float> texels(ranks.begin(), ranks.end());
  GlTexture texture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, side, side, 0, GL_RED, GL_FLOAT, texels.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  label(gl, GL_TEXTURE, texture.id(), "pattern of ranks");
  return texture;
}

}  // namespace

void DitherPass::prepare(Gl& gl, const Scene&) {
  ranks_ = {};
  if (method_ == "bayer") {
    side_ = matrix_size_;
    matrix_ = bayer_matrix(side_);
    ranks_ = upload_ranks(gl, matrix_, side_, "bayer_matrix");
  } else if (method_ == "blue-noise") {
    side_ = blue_noise_size;
    ranks_ = upload_ranks(gl, blue_noise(side_, first_points(side_)), side_, "blue_noise");
  }
}

// ---- Passes

void DitherPass::bind_camera(Binder& binder, const View& view) const {
  const Camera& camera = view.camera;
  const glm::dmat3 to_world(glm::inverse(glm::lookAt(camera.eye, camera.target, glm::dvec3(camera.up))));
  binder.set("u_view_to_world", glm::mat3(to_world));
  binder.set("u_half_height", float(std::tan(double(camera.fov_y) / 2)));  // of the picture at a distance of 1
  binder.set("u_cell", cell_);
  binder.set("u_eye_of_view", view.camera_relative ? glm::vec3(0) : glm::vec3(camera.eye));
}

ChainPass DitherPass::grey_pass() const {
  return {.name = "grey", .code = {"09-dithering/given/dither_pass.glsl", "grey_pass"}, .structure = no_lights()};
}

ChainPass DitherPass::shader_pass(const View& view) const {
  ChainPass pass{.name = "dither", .code = {"09-dithering/given/dither_pass.glsl", "dither_pass"}};
  pass.structure = no_lights();
  if (linear_) pass.structure["LINEAR"] = "1";
  if (grey_) pass.structure["GREY"] = "1";
  const bool has_pattern = method_ != "rounded";
  if (has_pattern) pass.structure["PATTERN"] = "1";
  if (has_pattern && held_ == "sphere") pass.structure["HELD_BY_SPHERE"] = "1";
  if (has_pattern && held_ == "world") {
    pass.structure["HELD_BY_WORLD"] = "1";
    pass.reads = {"position", "normal"};
  }
  pass.bind = [this, view](Binder& binder) {
    binder.set("u_levels", float(diffusion_.levels));
    bind_camera(binder, view);
    if (!ranks_) return;
    binder.set("u_side", side_);
    binder.texture("u_ranks", ranks_.id());
  };
  return pass;
}

ChainPass DitherPass::line_pass(const View& view) const {
  ChainPass pass{.name = "lines", .code = {"09-dithering/given/dither_pass.glsl", "line_pass"}};
  pass.structure = no_lights();
  pass.structure["LINES"] = lines_ == "white" ? "1.0" : "0.0";
  pass.reads = {"position", "normal"};
  pass.bind = [this, view](Binder& binder) { bind_camera(binder, view); };
  return pass;
}

// ---- On the CPU

namespace {

/// The value of each code in the space of the levels.
std::array<float, 256> values_of_codes(bool linear) {
  std::array<float, 256> values{};
  for (std::size_t code = 0; code < values.size(); ++code)
    values[code] = linear ? linear_of_code(std::uint8_t(code)) : float(code) * (1.0f / 255);
  return values;
}

/// The code of each level.
std::vector<std::uint8_t> codes_of_levels(int levels, bool linear) {
  std::vector<std::uint8_t> codes;
  for (int level = 0; level < levels; ++level) {
    const float value = float(level) / float(levels - 1);
    codes.push_back(linear ? srgb_code(value) : std::uint8_t(255 * value + 0.5f));
  }
  return codes;
}

void check_levels(const std::vector<std::uint8_t>& chosen, std::size_t pixels, int levels, const char* function) {
  if (chosen.size() != pixels)
    throw Error(fmt::format("{} returned {} levels for {} values", function, chosen.size(), pixels));
  if (const auto wrong = std::ranges::find_if(chosen, [&](int level) { return level >= levels; });
      wrong != chosen.end())
    throw Error(
        fmt::format("{} returned level {} of {} (allowed: 0 to {})", function, int(*wrong), levels, levels - 1));
}

}  // namespace

void DitherPass::diffuse(ByteImage& picture) const {
  const std::size_t pixels = picture.rgba.size() / 4;
  const std::vector<std::uint8_t> codes = codes_of_levels(diffusion_.levels, linear_);
  if (fast_) {
    const std::vector<std::uint8_t> chosen = diffused_fast(picture.rgba, picture.width, diffusion_.levels);
    check_levels(chosen, 4 * pixels, diffusion_.levels, "diffused_fast");
    for (std::size_t i = 0; i < pixels; ++i)
      for (std::size_t channel = 0; channel < 3; ++channel)
        picture.rgba[4 * i + channel] = codes[chosen[4 * i + channel]];
    return;
  }
  const std::array<float, 256> value_of = values_of_codes(linear_);
  const std::size_t channels = grey_ ? 1 : 3;
  std::array<std::vector<std::uint8_t>, 3> chosen;
  const auto run = [&](std::size_t channel) {
    std::vector<float> values(pixels);
    for (std::size_t i = 0; i < pixels; ++i) values[i] = value_of[picture.rgba[4 * i + channel]];
    chosen[channel] = diffused(values, picture.width, diffusion_);
  };
  for_each_parallel(channels, threads_, run);
  for (std::size_t channel = 0; channel < channels; ++channel)
    check_levels(chosen[channel], pixels, diffusion_.levels, "diffused");
  for (std::size_t i = 0; i < pixels; ++i)
    for (std::size_t channel = 0; channel < 3; ++channel)
      picture.rgba[4 * i + channel] = codes[chosen[std::min(channel, channels - 1)][i]];
}

ChainPass DitherPass::cpu_pass() const {
  ChainPass pass{.name = "dither"};
  pass.on_bytes = [this](ByteImage& picture, const PassInputs&) {
    if (diffuses())
      diffuse(picture);
    else
      dither_bytes(picture.rgba, picture.width, matrix_, side_, diffusion_.levels);
  };
  return pass;
}

std::vector<ChainPass> DitherPass::passes(const Scene&, const View& view) const {
  std::vector<ChainPass> passes;
  if (grey_ && (method_ == "none" || diffuses() || fast_)) passes.push_back(grey_pass());
  if (method_ == "none")
    passes.push_back({.name = "dither", .identity = true});
  else
    passes.push_back(diffuses() || fast_ ? cpu_pass() : shader_pass(view));
  if (lines_ != "none") passes.push_back(line_pass(view));
  passes.push_back({.name = "seen", .identity = true});
  return passes;
}

}  // namespace atelier
