#include "app/record.hpp"

#include <fmt/core.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "base/error.hpp"
#include "image_io/extension.hpp"
#include "image_io/image_io.hpp"

namespace atelier {

namespace {

constexpr double frames_a_second = 24;

/// The eye after turning by `angle` radians about the axis through `target` along `up` (Rodrigues' formula).
glm::dvec3 turned(const Camera& camera, double angle) {
  const glm::dvec3 axis = glm::normalize(glm::dvec3(camera.up)), arm = camera.eye - camera.target;
  const double c = std::cos(angle), s = std::sin(angle);
  return camera.target + arm * c + glm::cross(axis, arm) * s + axis * (glm::dot(axis, arm) * (1 - c));
}

// Interpolates with std::lerp, which never exceeds its ends, so the value stays in the setting's range.

int between(int from, int to, double share) {
  return int(std::lround(std::lerp(from, to, share)));
}
double between(double from, double to, double share) {
  return std::lerp(from, to, share);
}
Colour between(const Colour& from, const Colour& to, double share) {
  return {between(from.r, to.r, share), between(from.g, to.g, share), between(from.b, to.b, share)};
}

}  // namespace

void check_recording(const std::filesystem::path& file) {
  const std::string extension = image_io::lower_extension(file);
  for (const char* allowed : {".gif", ".png", ".bmp", ".exr"})
    if (extension == allowed) return;
  throw Error(
      fmt::format("--record {}: its name must end in .gif, or for numbered pictures in .png, .bmp or .exr, not in '{}'",
                  file.string(), extension));
}

Change turn_of_camera(const Camera& start) {
  return [start](Case& picture, double share) { picture.camera.eye = turned(start, glm::two_pi<double>() * share); };
}

VariedSetting varied_setting(const std::vector<SettingSpec>& specs, const std::string& name, const std::string& from,
                             const std::string& to) {
  const std::string asked = fmt::format("--vary {}={}..{}", name, from, to);
  Settings settings(specs);
  const SettingValue& value = settings.value(name);
  if (std::holds_alternative<bool>(value) || std::holds_alternative<std::string>(value))
    throw Error(asked + ": it has no numeric range; --set it, and vary another");
  const auto read = [&](const std::string& text) {
    settings.set(name, text);
    return settings.value(name);
  };
  VariedSetting varied{.name = name, .from = read(from), .to = read(to)};
  if (varied.from == varied.to) throw Error(asked + ": both ends are the same; --set it, or give another end");
  return varied;
}

Change change_of_setting(const VariedSetting& varied) {
  return [varied](Case& picture, double share) {
    SettingValue& value = picture.settings[varied.name];
    if (const int* whole = std::get_if<int>(&varied.from))
      value = between(*whole, std::get<int>(varied.to), share);
    else if (const double* real = std::get_if<double>(&varied.from))
      value = between(*real, std::get<double>(varied.to), share);
    else
      value = between(std::get<Colour>(varied.from), std::get<Colour>(varied.to), share);
  };
}

void record(Painter& painter, const Case& picture, const Change& change, Encoding encoding,
            const std::filesystem::path& file, int frames) {
  check_recording(file);
  const auto paint = [&](int i) {
    Case frame = picture;
    change(frame, double(i) / frames);
    return painter.paint(frame, i / frames_a_second);
  };
  if (image_io::lower_extension(file) == ".gif")
    return write_animation(file, frames, paint, 1 / frames_a_second, encoding);
  for (int i = 0; i < frames; ++i) {
    auto numbered = file;
    numbered.replace_filename(fmt::format("{}-{:04}{}", file.stem().string(), i, file.extension().string()));
    write_image(numbered, paint(i), {.encoding = encoding});
  }
}

}  // namespace atelier
