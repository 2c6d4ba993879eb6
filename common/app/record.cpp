#include "app/record.hpp"

#include <fmt/core.h>

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

}  // namespace

void check_recording(const std::filesystem::path& file) {
  const std::string extension = image_io::lower_extension(file);
  for (const char* allowed : {".gif", ".png", ".bmp", ".exr"})
    if (extension == allowed) return;
  throw Error(
      fmt::format("--record {}: its name must end in .gif, or for numbered pictures in .png, .bmp or .exr, not in '{}'",
                  file.string(), extension));
}

void record_turn(Painter& painter, const Camera& start, const Case& picture, Encoding encoding,
                 const std::filesystem::path& file, int frames) {
  check_recording(file);
  std::vector<Image> pictures;
  const bool animation = image_io::lower_extension(file) == ".gif";
  for (int i = 0; i < frames; ++i) {
    Case frame = picture;
    frame.camera.eye = turned(start, glm::two_pi<double>() * i / frames);
    Image image = painter.paint(frame, i / frames_a_second);
    if (animation) {
      pictures.push_back(std::move(image));
    } else {
      auto numbered = file;
      numbered.replace_filename(fmt::format("{}-{:04}{}", file.stem().string(), i, file.extension().string()));
      write_image(numbered, image, {.encoding = encoding});
    }
  }
  if (animation) write_animation(file, pictures, 1 / frames_a_second, encoding);
}

}  // namespace atelier
