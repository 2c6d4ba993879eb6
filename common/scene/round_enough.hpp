// How many flat pieces a round wall needs.
#pragma once

namespace atelier {

/// A round wall and the view of it.
struct RoundView {
  double radius = 1;    ///< of the circle through the corners, metres
  double distance = 1;  ///< along the view direction from the eye to the nearest visible part of the wall, metres
  double fov_y = 0.8;   ///< full vertical field of view, radians, below pi
  int height = 480;     ///< of the picture, pixels
  double pixels = 0.5;  ///< largest distance between a piece and the circle, pixels
};

/// The least number of pieces, 3..65536, whose sagitta R (1 - cos(pi / n)), the gap between the middle of a piece and
/// the circle, is at most `pixels` in the picture, seen head-on at that distance, where a pixel is 2 distance tan(fov_y
/// / 2) / height metres. 65536 if more would be needed. Throws atelier::Error naming a value that is not finite and
/// above 0, or an angle of pi or more.
int segments_for(const RoundView& view);

}  // namespace atelier
