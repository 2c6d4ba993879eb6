// How the picture is stored and sampled: settings of all step programs. Written pictures default to accuracy, since
// they are judged and measured; windows have other defaults.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "case/settings.hpp"
#include "gl/target.hpp"
#include "image/colour.hpp"

namespace atelier {

/// "frame.format", "frame.samples" and "frame.supersampling" with the defaults for written pictures: 32-bit floats, one
/// sample, no supersampling. Every program has these settings (SceneProgram appends them).
std::vector<SettingSpec> frame_settings();

/// "texture.format": float, or 8 for sRGB codes. For programs with textures, which must implement it.
SettingSpec texture_format_setting();

/// `specs` with the window's defaults for these settings: 8 bits, like a screen, and 4 samples per pixel, or 1 if the
/// driver has fewer than 4.
std::vector<SettingSpec> with_window_defaults(std::vector<SettingSpec> specs, int most_samples);

/// The target for a frame of `size` pixels, by the settings and the output's encoding. 8 bits are srgb8 for linear
/// light and rgba8 for output that the shader has encoded. Data is always 32-bit floats and one sample, since a mean of
/// depths or of directions is meaningless.
TargetSpec frame_target(glm::ivec2 size, Encoding encoding, DepthFormat depth, const Settings& settings);

/// The supersampling factor of a written picture, 1..4; always 1 for data.
int supersampling_of(Encoding encoding, const Settings& settings);

}  // namespace atelier
