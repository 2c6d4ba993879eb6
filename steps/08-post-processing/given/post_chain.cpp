#include "08-post-processing/given/post_chain.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "02-blinn-phong/given/shaders_alone.hpp"
#include "08-post-processing/given/cheat_sheet.hpp"
#include "app/scene_program.hpp"
#include "gl/debug.hpp"

namespace atelier {

using namespace post_processing;

ChainFunctions chain_functions() {
  return {.next_target = next_target,
          .draw_full_screen = draw_full_screen,
          .glsl = "08-post-processing/post_processing.glsl"};
}

std::vector<SettingSpec> post_settings() {
  std::vector<std::string> looks = look_names();
  looks.insert(looks.begin(), "none");
  return {
      {.name = "bloom.strength",
       .fallback = 0.0,
       .low = 0,
       .high = 4,
       .help = "how much of the blurred light is added"},
      {.name = "bloom.threshold", .fallback = 1.0, .low = 0, .high = 16, .help = "the luma above which light blooms"},
      {.name = "bloom.sigma", .fallback = 6.0, .low = 0.5, .high = 20, .help = "pixels: the width of the blur"},
      {.name = "tone.exposure", .fallback = 0.0, .low = -10, .high = 10, .help = "stops: each doubles the light"},
      {.name = "tone.curve",
       .fallback = std::string("none"),
       .choices = {"none", "reinhard", "filmic"},
       .help = "how light of any amount becomes what a display can show"},
      {.name = "tone.white",
       .fallback = 4.0,
       .low = 0.1,
       .high = 100,
       .help = "the luma that Reinhard's curve makes white"},
      {.name = "colour.hue", .fallback = 0.0, .low = -2, .high = 2, .help = "turns"},
      {.name = "colour.saturation", .fallback = 1.0, .low = 0, .high = 4, .help = "factor of the chroma"},
      {.name = "colour.brightness", .fallback = 1.0, .low = 0, .high = 4, .help = "factor of the luma"},
      {.name = "table.look", .fallback = std::string("none"), .choices = looks, .help = "a table of colours"},
      {.name = "table.size", .fallback = 9, .low = 2, .high = 65, .help = "grid points along each axis"},
      {.name = "table.lookup",
       .fallback = std::string("trilinear"),
       .choices = {"trilinear", "tetrahedral"},
       .help = "how colours between grid points are found"},
      {.name = "overlay.amount", .fallback = 0.0, .low = 0, .high = 1, .help = "of a sheet with the window's controls"},
      {.name = "chain.fused",
       .fallback = false,
       .help = "tone, adjust, table and overlay in one pass, as far as they follow one another"},
      {.name = "chain.dither", .fallback = false, .help = "add noise before values are stored in 8 bits"},
      {.name = "chain.fetches",
       .fallback = 0,
       .low = 0,
       .high = 128,
       .help = "a first pass that reads so many texels for each pixel and changes nothing: to compare times with"},
      chain_format_setting(),
  };
}

std::vector<OutputSpec> post_outputs() {
  return {{"bright", Encoding::linear, "the light that blooms", Stage::pass},
          {"blur", Encoding::linear, "the same, blurred", Stage::pass},
          {"bloom", Encoding::linear, "the picture after the bloom", Stage::pass},
          {"tone", Encoding::linear, "the picture after tone mapping", Stage::pass},
          {"adjust", Encoding::linear, "the picture after hue, saturation and brightness", Stage::pass},
          {"table", Encoding::linear, "the picture after the table of colours", Stage::pass}};
}

void PostChain::configure(const Settings& settings) {
  const std::string& curve = settings.choice("tone.curve");
  table_name_ = settings.choice("table.look");
  table_points_ = settings.integer("table.size");
  look_ = {.bloom = float(settings.real("bloom.strength")),
           .exposure = float(settings.real("tone.exposure")),
           .curve = curve == "reinhard" ? 1
                    : curve == "filmic" ? 2
                                        : 0,
           .hue = float(settings.real("colour.hue")),
           .saturation = float(settings.real("colour.saturation")),
           .brightness = float(settings.real("colour.brightness")),
           .table = table_name_ != "none",
           .overlay = float(settings.real("overlay.amount"))};
  threshold_ = float(settings.real("bloom.threshold"));
  sigma_ = float(settings.real("bloom.sigma"));
  white_ = float(settings.real("tone.white"));
  tetrahedral_ = settings.choice("table.lookup") == "tetrahedral";
  fuses_ = settings.flag("chain.fused");
  dithers_ = settings.flag("chain.dither");
  fetches_ = settings.integer("chain.fetches");
  const std::string& chain_format = settings.choice("chain.format");
  frame_has_8_bits_ = settings.choice("frame.format") == "8";
  chain_has_8_bits_ = chain_format == "8" || (chain_format == "frame" && frame_has_8_bits_);
  weights_ = look_.bloom > 0 ? gaussian_weights(sigma_) : std::vector<float>{1};
  if (weights_.empty()) weights_ = {1};
}

// ---- Textures

namespace {

/// A texture of floats with 4 channels, clamped at its edges and filtered linearly. Depth 1: a picture.
GlTexture upload(Gl& gl, GLenum target, const glm::ivec3& size, const Rgba* texels, const char* name) {
  GlTexture texture(gl);
  gl.BindTexture(target, texture.id());
  if (target == GL_TEXTURE_3D)
    gl.TexImage3D(target, 0, GL_RGBA32F, size.x, size.y, size.z, 0, GL_RGBA, GL_FLOAT, texels);
  else
    gl.TexImage2D(target, 0, GL_RGBA32F, size.x, size.y, 0, GL_RGBA, GL_FLOAT, texels);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(target, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.TexParameteri(target, wrap, GL_CLAMP_TO_EDGE);
  gl.BindTexture(target, 0);
  label(gl, GL_TEXTURE, texture.id(), name);
  return texture;
}

GlTexture upload(Gl& gl, const ColourTable& table) {
  const auto count = std::size_t(table.size) * std::size_t(table.size) * std::size_t(table.size);
  std::vector<Rgba> texels(count, Rgba{0, 0, 0, 1});  // black where a student's table is too short
  for (std::size_t i = 0; i < std::min(count, table.colours.size()); ++i)
    texels[i] = {table.colours[i].r, table.colours[i].g, table.colours[i].b, 1};
  return upload(gl, GL_TEXTURE_3D, glm::ivec3(table.size), texels.data(), "table of colours");
}

/// Row 0 of an image is at its top, of a texture at its bottom.
GlTexture upload(Gl& gl, const Image& image, const char* name) {
  Image flipped(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) flipped.at(x, y) = image.at(x, image.height() - 1 - y);
  return upload(gl, GL_TEXTURE_2D, {image.width(), image.height(), 1}, flipped.pixels().data(), name);
}

}  // namespace

void PostChain::prepare(Gl& gl, const Scene&) {
  table_texture_ = {};
  if (look_.table) {
    table_ = read_table(look_text(table_name_, table_points_));
    if (table_.size < 1 || table_.size > 256)
      throw Error(fmt::format("read_table returned a table of {} grid points a side (allowed: 1 to 256)", table_.size));
    table_texture_ = upload(gl, table_);
  }
  if (look_.overlay > 0 && !overlay_texture_) overlay_texture_ = upload(gl, make_cheat_sheet(640, 480), "cheat sheet");
}

// ---- Passes

ChainPass PostChain::shader_pass(const char* name, const char* function) const {
  ChainPass pass{.name = name, .code = {"08-post-processing/given/post_passes.glsl", function}};
  pass.structure = no_lights();
  pass.structure["CURVE"] = std::to_string(look_.curve);
  if (tetrahedral_) pass.structure["TETRAHEDRAL"] = "1";
  return pass;
}

void PostChain::bind(Binder& binder, Pass pass) const {
  switch (pass) {
    case Pass::bloom:
      binder.set("u_bloom", look_.bloom);
      break;
    case Pass::tone:
      binder.set("u_stops", look_.exposure);
      binder.set("u_white", white_);
      break;
    case Pass::adjust:
      binder.set("u_turns", look_.hue);
      binder.set("u_saturation", look_.saturation);
      binder.set("u_brightness", look_.brightness);
      break;
    case Pass::table:
      binder.set("u_table_size", float(table_.size));
      binder.set("u_table_low", table_.low);
      binder.set("u_table_high", table_.high);
      binder.texture("u_table", table_texture_.id(), GL_TEXTURE_3D);
      break;
    case Pass::overlay:
      binder.set("u_overlay_amount", look_.overlay);
      binder.texture("u_overlay", overlay_texture_.id());
      break;
  }
}

ChainPass PostChain::blur_pass(const char* name, const char* function) const {
  ChainPass pass = shader_pass(name, function);
  pass.structure["LAST_WEIGHT"] = std::to_string(weights_.size() - 1);
  pass.bind = [this](Binder& binder) {
    for (std::size_t k = 0; k < weights_.size(); ++k) binder.set(fmt::format("u_weights[{}]", k), weights_[k]);
  };
  return pass;
}

ChainPass PostChain::bloom_pass() const {
  ChainPass pass = shader_pass("bloom", "bloom_pass");
  pass.reads = {"colour"};
  pass.structure["BLOOM"] = "1";
  pass.bind = [this](Binder& binder) { bind(binder, Pass::bloom); };
  return pass;
}

ChainPass PostChain::fetching_pass() const {
  ChainPass pass = shader_pass("fetches", "fetching_pass");
  pass.structure["FETCHES"] = std::to_string(fetches_);
  pass.bind = [](Binder& binder) { binder.set("u_nowhere", glm::vec2(0)); };
  return pass;
}

namespace {

/// A pass that handles one pixel after another, by its output's name and its function in post_passes.glsl.
struct PixelPass {
  Pass pass;
  const char *name, *function, *value;
};
constexpr std::array<PixelPass, 4> pixel_passes = {{{Pass::tone, "tone", "tone_pass", "tone_of"},
                                                    {Pass::adjust, "adjust", "adjust_pass", "adjust_of"},
                                                    {Pass::table, "table", "table_pass", "table_of"},
                                                    {Pass::overlay, "overlay", "overlay_pass", "overlay_of"}}};

const PixelPass* pixel_pass(Pass pass) {
  const auto found = std::ranges::find(pixel_passes, pass, &PixelPass::pass);
  return found == pixel_passes.end() ? nullptr : &*found;
}

}  // namespace

std::vector<ChainPass> PostChain::passes_of(Pass wanted) const {
  if (wanted == Pass::bloom) {
    ChainPass bright = shader_pass("bright", "bright_pass");
    bright.bind = [this](Binder& binder) { binder.set("u_threshold", threshold_); };
    return {bright, blur_pass("blur_x", "blur_x_pass"), blur_pass("blur", "blur_y_pass"), bloom_pass()};
  }
  const PixelPass* known = pixel_pass(wanted);
  if (!known) throw Error(fmt::format("passes_for returned {}, which is no Pass", int(wanted)));
  ChainPass pass = shader_pass(known->name, known->function);
  pass.bind = [this, wanted](Binder& binder) { bind(binder, wanted); };
  return {pass};
}

/// One pass that does the work of several.
ChainPass PostChain::fused(std::span<const Pass> wanted) const {
  ChainPass pass = shader_pass(pixel_pass(wanted.back())->name, "fused_pass");
  std::string& steps = pass.structure["FUSED"];
  for (const Pass each : wanted) steps += fmt::format("c = {}(c, texcoord); ", pixel_pass(each)->value);
  pass.bind = [this, all = std::vector<Pass>(wanted.begin(), wanted.end())](Binder& binder) {
    for (const Pass each : all) bind(binder, each);
  };
  return pass;
}

std::vector<ChainPass> PostChain::passes(const Scene&, const View& view) const {
  const std::vector<Pass> wanted = passes_for(look_);
  std::vector<ChainPass> passes;
  const auto add = [&](std::vector<ChainPass> more) { std::ranges::move(more, std::back_inserter(passes)); };
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    std::size_t end = i;
    if (fuses_ && view.output == "colour")
      while (end < wanted.size() && pixel_pass(wanted[end])) ++end;
    if (end > i + 1) {
      passes.push_back(fused(std::span(wanted).subspan(i, end - i)));
      i = end - 1;
    } else {
      add(passes_of(wanted[i]));
    }
  }
  // Passes that are not needed are outputs too: the picture as it is before the next one.
  for (const Pass pass : {Pass::overlay, Pass::table, Pass::adjust, Pass::tone, Pass::bloom}) {
    if (std::ranges::count(wanted, pass) > 0) continue;
    ChainPass idle{.name = pixel_pass(pass) ? pixel_pass(pass)->name : "bloom", .identity = true};
    const auto next = std::ranges::find_if(wanted, [&](Pass other) { return int(other) > int(pass); });
    const std::string before = next == wanted.end() ? "" : passes_of(*next).front().name;
    const auto at = std::ranges::find(passes, before, &ChainPass::name);
    passes.insert(at, idle);
  }
  if (fetches_ > 0) passes.insert(passes.begin(), fetching_pass());
  if (dithers_)
    for (std::size_t i = 0; i < passes.size(); ++i) passes[i].structure["DITHER"] = std::to_string(i + 1);
  return passes;
}

// ---- The scene's own light

Need PostChain::need(const Scene&, const View& view, const Node&) const {
  if (!dithers_ || view.output != "colour") return {};
  const bool stored_in_8_bits = passes_for(look_).empty() ? frame_has_8_bits_ : chain_has_8_bits_;
  if (!stored_in_8_bits) return {};
  return {.wanted = true, .structure = {{"DITHER", "0"}, {"STORED_IN_8_BITS", "1"}}};
}

std::map<Slot, SlotCode> PostChain::slots() const {
  return {{Slot::modify_shaded, {"08-post-processing/given/dither_surface.glsl", "dithered_surface"}}};
}

}  // namespace atelier
