// 10-artstyles: what a pixel shader does. The contract of each function is the comment above it. Colours are linear
// light, at least 0. Texture coordinates run from (0, 0), the lower left corner of the picture, to (1, 1); `size` is
// that of the picture in pixels. Distances in a picture are in half heights: the middle of its upper edge is 1 away
// from its centre, that of its right edge size.x / size.y. Directions are in view space: x right, y up, -z ahead.
//
// Given, in the files included below: step 08's functions; vec3 shown(vec3 light), the brightness of each channel on a
// display in steps that are about even for the eye, 0 to 1.
#include "08-post-processing/post_processing.glsl"
#include "10-artstyles/given/shown.glsl"

// ---------------------------------------------------------------------------------------------------------------------
// Core 1: lines and greys
// ---------------------------------------------------------------------------------------------------------------------

// How strongly the picture changes at a pixel: the magnitude of Sobel's gradient (Sobel and Feldman 1968), of each
// channel of shown(colour), which is given. The gradient's first component is what the three pixels on the right have
// more than the three on the left, those in the middle counted twice; the second the same for those above and below.
// The magnitude is its length. The result is the largest of the three channels'. `pixel` is the distance of neighbours
// in texture coordinates; beyond its edges the picture goes on with the colours of its edges: that is given, by its
// wrap mode. Handout, section 1.
// A step from black to white between two columns gives 4 on both sides of it.
float edge_strength(sampler2D picture, vec2 texcoord, vec2 pixel) {
  // TODO(10-artstyles): eight neighbours
  return 0.0;
}

// A colour in one of six greys, with ink over it. Its brightness is the square root of its luma (step 08's
// `float luma(vec3)`), which is taken as 1 if it is above; the grey has the nearest of the brightnesses 0, 1/5, 2/5,
// 3/5, 4/5, 1, half way between two either. The light of a grey is the square of its brightness. Where the edge is
// `low` or weaker there is no ink, and the result is this grey; where it is `high` or stronger, it is black. Between
// them the share of ink is 3 t^2 - 2 t^3, t being 0 at `low` and 1 at `high`. 0 <= low < high. Handout, section 2.
vec3 toon(vec3 colour, float edge, float low, float high) {
  // TODO(10-artstyles): a grey, then ink
  return colour;
}

// How much the surface changes at a pixel. around[3 * row + column] are the nine pixels, rows from the top, around[4]
// this pixel: xyz is the normal, of unit length, w the reciprocal of the depth (the distance along the view's axis), in
// 1/m. All are 0 where nothing is seen. On a plane w changes evenly from pixel to pixel.
// x: the largest step in depth. For a pair of opposite neighbours a and b it is |a.w + b.w - 2 around[4].w|, divided by
// the largest of the three w, and 0 where all three are 0; there are four pairs.
// y: the largest bend: the length of the difference of a neighbour's normal and this pixel's.
// Handout, section 3.
vec2 surface_steps(vec4 around[9]) {
  // TODO(10-artstyles): four pairs, eight neighbours
  return vec2(0.0);
}

// ---------------------------------------------------------------------------------------------------------------------
// Core 2: lenses
// ---------------------------------------------------------------------------------------------------------------------

// Where a pixel takes its colour from, in texture coordinates: the place in the same direction from the centre of the
// picture as the pixel, but at the distance r (1 + strength * r^power), r being the pixel's own distance in half
// heights. strength is at least 0, power at least 1. Handout, section 4.
vec2 power_source(vec2 texcoord, vec2 size, float strength, float power) {
  // TODO(10-artstyles): a length, a factor
  return texcoord;
}

// The direction in which an equidistant fish-eye lens looks at a pixel, of unit length. The angle between it and the
// axis, straight ahead, is proportional to the distance from the centre, and half_angle (radians, above 0, up to pi) at
// a distance of 1 half height; to the right of the centre it looks to the right, above it upwards. Farther away there
// is no picture: vec3(0). At a distance of exactly 1 either is right. Handout, section 4.
vec3 fisheye_direction(vec2 texcoord, vec2 size, float half_angle) {
  // TODO(10-artstyles): an angle, and its sine
  return vec3(0.0, 0.0, -1.0);
}

// The colour in a direction (of any length), as far as an ordinary picture in perspective shows it. half_size is how
// far its right and upper edges are from its centre, in metres, 1 m ahead of the eye. What is outside the picture,
// beside or behind the eye is black, and so is the direction vec3(0). Handout, section 4.
vec3 colour_in_direction(sampler2D picture, vec3 direction, vec2 half_size) {
  // TODO(10-artstyles): which point of the picture is in this direction?
  return texture(picture, vec2(0.5)).rgb;
}

// The picture with its channels apart. Channel c (0 red, 1 green, 2 blue) comes from the place in the same direction
// from the centre, at 1 + amount * sin(2 pi (turns + c / 3)) times the distance. turns is 0..10. Handout, section 4.
vec3 aberrated(sampler2D picture, vec2 texcoord, float amount, float turns) {
  // TODO(10-artstyles): three places
  return texture(picture, texcoord).rgb;
}

// ---------------------------------------------------------------------------------------------------------------------
// Further: from the scene to the picture
// ---------------------------------------------------------------------------------------------------------------------

// (further) The inverse of fisheye_direction: the texture coordinates where a direction (of any length from
// 1e-12 to 1e12) is seen; beyond the circle too. Straight behind the eye, any place at the distance of this angle.
// Small angles keep their accuracy: a direction 0.001 degrees from the axis is not at the centre. Handout, section 9.
vec2 fisheye_place(vec3 direction, vec2 size, float half_angle) {
  // TODO(10-artstyles): an angle of any size
  return vec2(0.5);
}

// (further) The inverse of power_source: the texture coordinates whose colour comes from `source`, up to 20 half
// heights from the centre, for all strengths from 0 to 10 and powers from 1 to 8, to 1e-5 of the distance or 1e-6,
// whichever is more. Handout, section 9.
vec2 power_place(vec2 source, vec2 size, float strength, float power) {
  // TODO(10-artstyles): a root
  return source;
}

// ---------------------------------------------------------------------------------------------------------------------
// Challenge: relief behind a lens
// ---------------------------------------------------------------------------------------------------------------------

// (challenge) A normal map is seen through a lens: it is the relief of a height field h(source), a height for each
// place of the picture, and what is seen is the relief h(source(place)). `normal` is the unit normal of the first one,
// with z above 0 (z is towards the viewer); the result is the unit normal of the second. jacobian[i] is the derivative
// of `source` by component i of `place`. Handout, section 10.
vec3 distorted_normal(vec3 normal, mat2 jacobian) {
  // TODO(10-artstyles): the slopes of a function of a function
  return normal;
}
