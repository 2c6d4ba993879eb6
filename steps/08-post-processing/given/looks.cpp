#include "08-post-processing/given/looks.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace atelier {

namespace {

/// Darker below the middle and brighter above it, by so much of a smooth step.
glm::dvec3 with_contrast(const glm::dvec3& c, double amount) {
  return glm::mix(c, c * c * (3.0 - 2.0 * c), amount);
}

}  // namespace

std::vector<std::string> look_names() {
  return {"identity", "warm", "night"};
}

glm::dvec3 look_of(const std::string& name, const glm::dvec3& encoded) {
  if (name == "warm")
    return glm::clamp(with_contrast(encoded, 0.4) * glm::dvec3(1.06, 1.0, 0.86) + glm::dvec3(0.015, 0.005, 0), 0.0,
                      1.0);
  if (name == "night") {
    const double grey = glm::dot(encoded, glm::dvec3(0.3, 0.6, 0.1));
    // The darker a colour is, the less of it is left.
    return glm::mix(glm::dvec3(grey), encoded, 0.1 + 0.8 * grey) * glm::dvec3(0.42, 0.55, 0.85);
  }
  return encoded;
}

std::string look_text(const std::string& name, int size) {
  std::string text =
      fmt::format("# A look of Atelier, for sRGB-encoded colours.\nTITLE \"{}\"\nLUT_3D_SIZE {}\n", name, size);
  for (int b = 0; b < size; ++b)
    for (int g = 0; g < size; ++g)
      for (int r = 0; r < size; ++r) {
        const glm::dvec3 colour = look_of(name, glm::dvec3(r, g, b) / double(size - 1));
        text += fmt::format("{:.6f} {:.6f} {:.6f}\n", colour.r, colour.g, colour.b);
      }
  return text;
}

}  // namespace atelier
