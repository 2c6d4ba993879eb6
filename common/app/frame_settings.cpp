#include "app/frame_settings.hpp"

#include <string>

namespace atelier {

namespace {

constexpr int window_samples = 4;

ColourFormat colour_format(Encoding encoding, const std::string& format) {
  if (format == "16f") return ColourFormat::rgba16f;
  if (format == "32f") return ColourFormat::rgba32f;
  return encoding == Encoding::srgb ? ColourFormat::rgba8 : ColourFormat::srgb8;
}

}  // namespace

std::vector<SettingSpec> frame_settings() {
  return {
      {.name = "frame.format",
       .fallback = std::string("32f"),
       .choices = {"32f", "16f", "8"},
       .help = "how the picture's colours are stored: floats of 32 or 16 bits, or sRGB codes of 8 bits, clamped to 1 "
               "(default in a window: 8); data outputs are always 32f"},
      {.name = "frame.samples",
       .fallback = std::string("1"),
       .choices = {"1", "4"},
       .help = "samples per pixel: depth is tested per sample, colour computed once per pixel (default in a window: "
               "4); samples are averaged in linear light, or as codes for an encoded output; data outputs have 1"},
      {.name = "frame.supersampling",
       .fallback = 1,
       .low = 1,
       .high = 4,
       .help = "written pictures are drawn this many times as wide and high, and averaged in linear light; not in a "
               "window, and not for data outputs"},
  };
}

SettingSpec texture_format_setting() {
  return {.name = "texture.format",
          .fallback = std::string("float"),
          .choices = {"float", "8"},
          .help = "how texels are stored: floats of 32 bits, or 8 bits (sRGB codes), a quarter of the memory"};
}

std::vector<SettingSpec> with_window_defaults(std::vector<SettingSpec> specs, int most_samples) {
  for (SettingSpec& spec : specs) {
    if (spec.name == "frame.format") spec.fallback = std::string("8");
    if (spec.name == "frame.samples" && most_samples >= window_samples) spec.fallback = std::to_string(window_samples);
  }
  return specs;
}

TargetSpec frame_target(glm::ivec2 size, Encoding encoding, DepthFormat depth, const Settings& settings) {
  TargetSpec spec{.width = size.x, .height = size.y, .colour = ColourFormat::rgba32f, .depth = depth};
  if (encoding == Encoding::data) return spec;
  spec.colour = colour_format(encoding, settings.choice("frame.format"));
  spec.samples = std::stoi(settings.choice("frame.samples"));
  return spec;
}

int supersampling_of(Encoding encoding, const Settings& settings) {
  return encoding == Encoding::data ? 1 : settings.integer("frame.supersampling");
}

}  // namespace atelier
