// Pictures in textures, for the functions of step 10 that read one.
#pragma once

#include "gl/objects.hpp"
#include "stability/10-artstyles/rows.hpp"

namespace atelier::stability {

/// A picture, row by row from the bottom.
struct Texels {
  int width = 1, height = 1;
  std::vector<glm::vec4> colours;

  Texels(int w, int h, const glm::vec3& fill = glm::vec3(0))
      : width(w), height(h), colours(std::size_t(w) * std::size_t(h), glm::vec4(fill, 1)) {}
  glm::vec4& at(int x, int y) { return colours[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
  /// Beyond its edges the picture goes on with the colours of its edges.
  const glm::vec4& clamped(int x, int y) const {
    const int u = std::clamp(x, 0, width - 1), v = std::clamp(y, 0, height - 1);
    return colours[std::size_t(v) * std::size_t(width) + std::size_t(u)];
  }
  glm::vec2 size() const { return {width, height}; }
};

/// The light of each channel evenly spread over low .. high.
Texels random_texels(int width, int height, double low, double high);

/// A picture whose filtered colour is where it was read: all channels are texture coordinate `axis` (0 or 1). Within
/// half a texel of its edges it is that half texel.
Texels coordinate_texels(int axis);
inline constexpr int coordinate_side = 64;
double read_coordinate(double texcoord);  ///< what it then is

/// What a read of it may be off: drivers mix texels, which are 1/64 apart, by weights of at least 8 bits.
inline constexpr double read_error = 1.0 / 256 / coordinate_side;

/// What functions give for calls that may use the picture as `u_texels`; its edges are clamped.
std::vector<glm::vec4> results_with(ShaderFunctions& shaders, const Texels& texels, bool linear,
                                    std::vector<std::string> parameters, std::string expression,
                                    const std::vector<ShaderInput>& calls);

}  // namespace atelier::stability
