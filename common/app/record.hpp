// Draws a sequence with a fixed time step, as an animation or as numbered pictures: a camera orbit, or a setting that
// changes from one value to another.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "app/picture.hpp"
#include "image/colour.hpp"

namespace atelier {

/// Throws Error naming the allowed extensions, unless `file` ends in .gif, .png, .bmp or .exr.
void check_recording(const std::filesystem::path& file);

/// Changes a picture of a recording. `share` is 0 in the first of n pictures, (n - 1) / n in the last: without the end
/// itself, so that periodic motion loops without a pause.
using Change = std::function<void(Case& picture, double share)>;

/// The camera orbits its target once, about the up axis.
Change turn_of_camera(const Camera& start);

/// A setting that changes from one value to another: two integers, two reals or two colours.
struct VariedSetting {
  std::string name;
  SettingValue from, to;
};

/// Parses both ends. Throws Error naming the setting, the value and what is allowed if the name is unknown, an end is
/// out of range or of another type, the setting is a flag or a choice, or both ends are the same.
VariedSetting varied_setting(const std::vector<SettingSpec>& specs, const std::string& name, const std::string& from,
                             const std::string& to);

/// The setting changes from one end to the other in even steps; integers are rounded to the nearest, colours are
/// interpolated in linear light.
Change change_of_setting(const VariedSetting& varied);

/// Draws `frames` pictures, 24 per second. A .gif is one animation; other files become NAME-0000.EXT and so on.
/// `encoding` is that of the output. Throws Error as check_recording() does, and if a file cannot be written.
void record(Painter& painter, const Case& picture, const Change& change, Encoding encoding,
            const std::filesystem::path& file, int frames);

}  // namespace atelier
