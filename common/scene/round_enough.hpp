// How many flat pieces make a round wall round.
#pragma once

namespace atelier {

/// Something round, and how large it is seen.
struct RoundView {
  double radius = 1;    ///< metres, of the circle that the corners lie on
  double distance = 1;  ///< metres along the view from the eye to the nearest part of the wall that is seen
  double fov_y = 0.8;   ///< radians, the full vertical angle of view, below pi
  int height = 480;     ///< pixels of the picture
  double pixels = 0.5;  ///< how far a piece may stay behind the circle, pixels
};

/// The least number of pieces, 3..65536, whose sagitta R (1 - cos(pi / n)), the gap between the middle of a piece and
/// the circle, is at most `pixels` in the picture, seen square on at that distance, where a pixel is
/// 2 distance tan(fov_y / 2) / height metres. 65536 where no more would do: floats end there too. Throws
/// atelier::Error naming a measure that is not finite and above 0, or an angle of pi or more.
int segments_for(const RoundView& view);

}  // namespace atelier
