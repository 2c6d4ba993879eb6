// Which lights of a scene nobody could see, because all of them together change the picture by less than one code of
// its 255.
#pragma once

#include <functional>
#include <vector>

#include "scene/scene.hpp"

namespace atelier {

/// The most of a light that arrives anywhere in a box, for each channel: colour / (c0 + c1 d + c2 d^2) at the box's
/// nearest point, where a distance below a millimetre counts as one; the colour of a directional light; nothing of a
/// spot whose cone misses the sphere around the box. Cosines between light and surface count as 1.
glm::dvec3 most_arriving(const Light& light, const Box3& box);

/// The most that a surface gives back of what arrives, over all directions and for each channel: kd + ks peak(n), where
/// `peak` is the height of the highlight's lobe for an exponent n >= 0 (1, or its normalisation). Textures are taken
/// to be at most 1. Of several materials: the largest, channel by channel.
glm::dvec3 most_given_back(const std::vector<Material>& materials, const std::function<double(double)>& peak);

/// How much linear light changes an sRGB picture by one 255th where it is steepest, at black: 1 / (255 * 12.92), since
/// the encoding begins with the slope 12.92 (IEC 61966-2-1) and is flatter everywhere else.
inline constexpr double least_visible_light = 1 / (255 * 12.92);

/// The box around everything that the scene draws, in world space and wherever floats may draw it: around `node_boxes`.
Box3 box_of_drawn(const Scene& scene);

/// Indices of the lights that must be drawn, in the scene's order. The others are left out because the SUM of what they
/// could add at any point of `box`, to any material and seen from anywhere, is below least_visible_light in each
/// channel; so no pixel of the encoded picture changes by 1/255. (One alone would not do: a hundred lights below the
/// limit add up.) Those that give least are left out first. A light of colour 0 goes for nothing. For a scene, `box` is
/// its `box_of_drawn`.
std::vector<int> lights_that_matter(const std::vector<Light>& lights, const glm::dvec3& given_back, const Box3& box);

}  // namespace atelier
