// The colour of a texture at a point, without mipmaps: supersampling replaces them.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.hpp"

namespace atelier::oracle {

/// Red, green and blue of a texel by its column from the left and its row from the bottom, both whole numbers. Outside
/// the picture `wrap` applies.
glm::dvec3 texel(const Texture& texture, double column, double row);

/// Red, green and blue at a texture coordinate, (0,0) being the lower left corner of the picture and (1,1) the upper
/// right. Filter::nearest takes the texel that contains the point; the others interpolate the four texels around it
/// (OpenGL 3.3 core specification, 3.8.8), in double precision. Outside the picture `wrap` applies.
glm::dvec3 texel_colour(const Texture& texture, const glm::dvec2& texcoord);

}  // namespace atelier::oracle
