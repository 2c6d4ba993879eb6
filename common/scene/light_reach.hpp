// Finds lights that are too weak to be visible: all of them together change the picture by less than 1/255.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "scene/scene.hpp"

namespace atelier {

/// Upper bound per channel of the light that arrives anywhere in a box: colour / (c0 + c1 d + c2 d^2) at the box's
/// nearest point, with d at least 1 mm; the colour of a directional light; 0 for a spot whose cone misses the sphere
/// around the box. Cosines between light and surface count as 1.
glm::dvec3 most_arriving(const Light& light, const Box3& box);

/// Upper bound per channel of the fraction of light that a surface reflects, over all directions: kd + ks peak(n),
/// where `peak` is the height of the highlight's lobe for an exponent n >= 0 (1, or its normalisation). Assumes
/// textures of at most 1. For several materials the maximum, per channel.
glm::dvec3 most_given_back(const std::vector<Material>& materials, const std::function<double(double)>& peak);

/// The linear light that changes an sRGB picture by 1/255 at black, where the encoding is steepest, with slope 12.92
/// (IEC 61966-2-1).
inline constexpr double least_visible_light = 1 / (255 * 12.92);

/// The bounding box of everything drawn, in world space, including float error: around the scene's `node_boxes`.
Box3 box_of_drawn(std::span<const Box3> node_boxes);

/// Indices of the lights that must be drawn, in the scene's order. For the others, the SUM of their possible
/// contributions at any point of `box`, for any material and view direction, is below least_visible_light in each
/// channel, so no pixel of the encoded picture changes by 1/255. (A limit per light is not enough: a hundred weak
/// lights add up.) The weakest lights are left out first; a light of colour 0 always is. For a scene, `box` is its
/// `box_of_drawn`.
std::vector<int> lights_that_matter(const std::vector<Light>& lights, const glm::dvec3& given_back, const Box3& box);

/// Of the lights `among`, those that must be drawn in a part of the scene, such as on one node: the other ones of
/// `lights` have been left out already, and what they give in this box counts. `among` is in ascending order.
std::vector<int> lights_that_matter(const std::vector<Light>& lights, const glm::dvec3& given_back, const Box3& box,
                                    std::span<const int> among);

}  // namespace atelier
