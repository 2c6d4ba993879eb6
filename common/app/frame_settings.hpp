// How the picture itself is stored and sampled: settings that every step program has. Accuracy is the default where
// pictures are written, since they are judged and measured; a window has another.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "case/settings.hpp"
#include "gl/target.hpp"
#include "image/colour.hpp"

namespace atelier {

/// "frame.format", "frame.samples" and "frame.supersampling" with the defaults of pictures that are written: floats of
/// 32 bits, one sample, no supersampling. Every program has them among its settings (SceneProgram appends them).
std::vector<SettingSpec> frame_settings();

/// "texture.format": float, or 8 for sRGB codes. For programs with textures, whose own part it is to heed it.
SettingSpec texture_format_setting();

/// `specs` with the defaults of a window, where these settings are among them: 8 bits, which is all that a screen
/// shows, and 4 samples a pixel, or 1 where the driver has fewer than 4.
std::vector<SettingSpec> with_window_defaults(std::vector<SettingSpec> specs, int most_samples);

/// What a frame of `size` pixels is drawn into: the one place that knows what the settings mean for an output's
/// encoding. 8 bits are srgb8 for linear light and rgba8 for what the shader has encoded already. Data is no light:
/// always floats of 32 bits and one sample, since the mean of two depths or of two directions is neither.
TargetSpec frame_target(glm::ivec2 size, Encoding encoding, DepthFormat depth, const Settings& settings);

/// How many times as wide and as high a written picture is drawn, 1..4; always 1 for data.
int supersampling_of(Encoding encoding, const Settings& settings);

}  // namespace atelier
