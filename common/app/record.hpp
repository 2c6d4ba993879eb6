// Draws a sequence on a fixed clock, as an animation or as numbered pictures: a turn round the scene, or a setting that
// runs from one value to another.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "app/picture.hpp"
#include "image/colour.hpp"

namespace atelier {

/// Throws Error, naming the endings allowed, unless `file` ends in .gif, or in .png, .bmp or .exr.
void check_recording(const std::filesystem::path& file);

/// What a recording changes in each of its pictures. `share` of the way is 0 in the first of n, (n - 1) / n in the
/// last: the end itself is left out, so that what returns there to where it began goes on without a halt when it is
/// repeated.
using Change = std::function<void(Case& picture, double share)>;

/// The camera goes once round its target, about the up axis.
Change turn_of_camera(const Camera& start);

/// A setting that runs from one value to another: two whole numbers, two reals or two colours.
struct VariedSetting {
  std::string name;
  SettingValue from, to;
};

/// Reads both ends. Throws Error naming the setting, the value and what is allowed where the name is unknown, an end is
/// out of range or not of the setting's type, the setting is on or off or a choice, or both ends are the same.
VariedSetting varied_setting(const std::vector<SettingSpec>& specs, const std::string& name, const std::string& from,
                             const std::string& to);

/// The setting goes from one end to the other in even steps; a whole number is rounded to the nearest, and a colour
/// goes evenly in linear light.
Change change_of_setting(const VariedSetting& varied);

/// `frames` pictures, 24 a second. A .gif is one animation; other files become NAME-0000.EXT and so on. `encoding` is
/// that of the output drawn. Throws Error as check_recording() does, and where nothing can be written.
void record(Painter& painter, const Case& picture, const Change& change, Encoding encoding,
            const std::filesystem::path& file, int frames);

}  // namespace atelier
