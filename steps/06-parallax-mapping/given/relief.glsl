// The relief of a material, as the functions of step 06 see it. Given.

// Heights, 0 to 1, in red.
uniform sampler2D u_height_map;

// The change of the texture coordinate from pixel to pixel, of the surface and not of the relief. Inside a loop whose
// number of turns differs between neighbouring pixels, texture() has no derivatives to choose a mipmap level by.
vec2 texcoord_dx = vec2(0.0), texcoord_dy = vec2(0.0);

// The height of the relief, 0 to 1.
float height_at(vec2 texcoord) { return textureGrad(u_height_map, texcoord, texcoord_dx, texcoord_dy).r; }
