// Pictures to judge, drawn by a few lines of ray casting: a bumpy shiny sphere over a textured floor, with a shadow.
// Every way of being right or wrong that a test needs is a member to change.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <limits>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "judge/compare/answer.hpp"
#include "judge/compare/judged_case.hpp"

namespace atelier::judge::test {

inline constexpr float infinity = std::numeric_limits<float>::infinity();
inline constexpr float nan = std::numeric_limits<float>::quiet_NaN();

struct Drawing {
  int size = 192;                     ///< pixels a side; 2x2 samples a pixel
  double yaw = 0.4;                   ///< radians: the camera's place on its circle
  double offset_x = 0, offset_y = 0;  ///< pixels that the sample points are moved
  double light_yaw = 0.9;

  // Right in another way
  bool reformulated = false;  ///< the same formulas in floats, in another order

  // Wrong
  double exponent = 32;            ///< of the highlight
  double texel_offset = 0;         ///< texels
  bool nearest = false;            ///< texture filtering
  bool green_flipped = false;      ///< of the bumps
  bool mirrored_for_half = false;  ///< R.V in place of N.H
  bool no_ambient = false;
  bool no_highlight = false;
  bool no_cosine = false;  ///< N.L is missing
  bool no_shadow = false;
  bool hole_in_shadow = false;
};

/// Linear colours.
Image draw(const Drawing& drawing);

/// Directions as n/2 + 1/2, and distances from the camera as they are.
Image draw_normals(const Drawing& drawing);
Image draw_depth(const Drawing& drawing);

/// Adds -amplitude..amplitude of encoded 1/255 to every channel, by a fixed pattern.
Image with_noise(const Image& linear, double amplitude);

/// One pixel wide, `length` long, in the middle: darkened by a third.
Image with_line(Image linear, int length);

/// 1-bit ordered dithering of a ramp by the 8x8 Bayer matrix or its transpose; 0 and 1.
Image dithered_ramp(int size, bool transposed);

/// A picture case "sphere" of 10 points with the given profile, unit and tolerance, its size that of `draw`.
JudgedCase picture_case(Profile profile = Profile::strict, Unit unit = Unit::colour, double delta = 3, int budget = 4);

/// An answer that came in time.
Answer answer_of(Image picture);
Answer answer_of(std::vector<Numbers> values);

/// The same picture with every pixel replaced: from another place, or by another value.
Image moved(const Image& image, const std::function<glm::ivec2(int, int)>& source);
Image changed(Image image, const std::function<Rgba(const Rgba&)>& value);

}  // namespace atelier::judge::test
