// A picture to lay over others: a sheet of keys and what they do. Given.
#pragma once

#include "image/image.hpp"

namespace atelier {

/// The sheet for a picture of this size: transparent but for a dark panel with rounded corners in the lower left
/// corner. Colours are linear and not multiplied by their opacity, which is 0.7 on the panel, 1 on keys and letters,
/// and between on the rounded edges; transparent pixels have the panel's colour, so that filtering mixes opacities
/// alone. All lengths are whole multiples of height / 240, rounded down. Where that is 0, or the picture is too narrow
/// for the panel, all of it is transparent. Throws Error as Image does for a size.
Image make_cheat_sheet(int width, int height);

}  // namespace atelier
