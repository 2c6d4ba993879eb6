// A picture of exact codes, on which methods that amplify differences have one right result on each machine.
#pragma once

#include <glm/glm.hpp>

#include "image/image.hpp"
#include "scene/scene.hpp"

namespace atelier {

inline constexpr glm::ivec2 card_size{160, 120};

/// A sunset by the sea, with whole numbers only: the linear values of its sRGB codes, which have noise of a few codes
/// so that no part of it is flat.
Image make_card();

/// It fills the view, one texel a pixel in pictures of its size.
Scene make_card_scene();

}  // namespace atelier
