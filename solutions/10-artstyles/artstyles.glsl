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
  // >>> student: eight neighbours
  vec2 x = vec2(pixel.x, 0.0), y = vec2(0.0, pixel.y);
  vec3 upper_left = shown(texture(picture, texcoord - x + y).rgb), above = shown(texture(picture, texcoord + y).rgb);
  vec3 upper_right = shown(texture(picture, texcoord + x + y).rgb), left = shown(texture(picture, texcoord - x).rgb);
  vec3 right = shown(texture(picture, texcoord + x).rgb), lower_left = shown(texture(picture, texcoord - x - y).rgb);
  vec3 below = shown(texture(picture, texcoord - y).rgb), lower_right = shown(texture(picture, texcoord + x - y).rgb);
  vec3 across = upper_right + 2.0 * right + lower_right - upper_left - 2.0 * left - lower_left;
  vec3 up = upper_left + 2.0 * above + upper_right - lower_left - 2.0 * below - lower_right;
  vec3 squares = across * across + up * up;
  return sqrt(max(squares.r, max(squares.g, squares.b)));
  // --- skeleton
  // | return 0.0;
  // <<< student
}

// A colour in one of six greys, with ink over it. Its brightness is the square root of its luma (step 08's
// `float luma(vec3)`), which is taken as 1 if it is above; the grey has the nearest of the brightnesses 0, 1/5, 2/5,
// 3/5, 4/5, 1, half way between two either. The light of a grey is the square of its brightness. Where the edge is
// `low` or weaker there is no ink, and the result is this grey; where it is `high` or stronger, it is black. Between
// them the share of ink is 3 t^2 - 2 t^3, t being 0 at `low` and 1 at `high`. 0 <= low < high. Handout, section 2.
vec3 toon(vec3 colour, float edge, float low, float high) {
  // >>> student: a grey, then ink
  float grey = round(5.0 * sqrt(clamp(luma(colour), 0.0, 1.0))) / 5.0;
  return vec3(grey * grey * (1.0 - smoothstep(low, high, edge)));
  // --- skeleton
  // | return colour;
  // <<< student
}

// How much the surface changes at a pixel. around[3 * row + column] are the nine pixels, rows from the top, around[4]
// this pixel: xyz is the normal, of unit length, w the reciprocal of the depth (the distance along the view's axis), in
// 1/m. All are 0 where nothing is seen. On a plane w changes evenly from pixel to pixel.
// x: the largest step in depth. For a pair of opposite neighbours a and b it is |a.w + b.w - 2 around[4].w|, divided by
// the largest of the three w, and 0 where all three are 0; there are four pairs.
// y: the largest bend: the length of the difference of a neighbour's normal and this pixel's.
// Handout, section 3.
vec2 surface_steps(vec4 around[9]) {
  // >>> student: four pairs, eight neighbours
  vec2 most = vec2(0.0);
  vec4 here = around[4];
  for (int i = 0; i < 4; ++i) {
    vec4 a = around[i], b = around[8 - i];
    float nearest = max(here.w, max(a.w, b.w));
    if (nearest > 0.0) most.x = max(most.x, abs(a.w + b.w - 2.0 * here.w) / nearest);
    most.y = max(most.y, max(distance(a.xyz, here.xyz), distance(b.xyz, here.xyz)));
  }
  return most;
  // --- skeleton
  // | return vec2(0.0);
  // <<< student
}

// ---------------------------------------------------------------------------------------------------------------------
// Core 2: lenses
// ---------------------------------------------------------------------------------------------------------------------

// Where a pixel takes its colour from, in texture coordinates: the place in the same direction from the centre of the
// picture as the pixel, but at the distance r (1 + strength * r^power), r being the pixel's own distance in half
// heights. strength is at least 0, power at least 1. Handout, section 4.
vec2 power_source(vec2 texcoord, vec2 size, float strength, float power) {
  // >>> student: a length, a factor
  vec2 from_centre = texcoord - 0.5;
  float r = length(from_centre * vec2(2.0 * size.x / size.y, 2.0));
  return 0.5 + from_centre * (1.0 + strength * pow(r, power));
  // --- skeleton
  // | return texcoord;
  // <<< student
}

// The direction in which an equidistant fish-eye lens looks at a pixel, of unit length. The angle between it and the
// axis, straight ahead, is proportional to the distance from the centre, and half_angle (radians, above 0, up to pi) at
// a distance of 1 half height; to the right of the centre it looks to the right, above it upwards. Farther away there
// is no picture: vec3(0). At a distance of exactly 1 either is right. Handout, section 4.
vec3 fisheye_direction(vec2 texcoord, vec2 size, float half_angle) {
  // >>> student: an angle, and its sine
  vec2 place = (2.0 * texcoord - 1.0) * vec2(size.x / size.y, 1.0);
  float r = length(place), angle = r * half_angle;
  if (r > 1.0) return vec3(0.0);
  return vec3(r > 0.0 ? place / r * sin(angle) : vec2(0.0), -cos(angle));
  // --- skeleton
  // | return vec3(0.0, 0.0, -1.0);
  // <<< student
}

// The colour in a direction (of any length), as far as an ordinary picture in perspective shows it. half_size is how
// far its right and upper edges are from its centre, in metres, 1 m ahead of the eye. What is outside the picture,
// beside or behind the eye is black, and so is the direction vec3(0). Handout, section 4.
vec3 colour_in_direction(sampler2D picture, vec3 direction, vec2 half_size) {
  // >>> student: which point of the picture is in this direction?
  if (direction.z >= 0.0) return vec3(0.0);
  vec2 place = direction.xy / -direction.z / half_size;
  if (max(abs(place.x), abs(place.y)) > 1.0) return vec3(0.0);
  return texture(picture, 0.5 * place + 0.5).rgb;
  // --- skeleton
  // | return texture(picture, vec2(0.5)).rgb;
  // <<< student
}

// The picture with its channels apart. Channel c (0 red, 1 green, 2 blue) comes from the place in the same direction
// from the centre, at 1 + amount * sin(2 pi (turns + c / 3)) times the distance. turns is 0..10. Handout, section 4.
vec3 aberrated(sampler2D picture, vec2 texcoord, float amount, float turns) {
  // >>> student: three places
  vec3 factor = 1.0 + amount * sin(6.28318530718 * (turns + vec3(0.0, 1.0, 2.0) / 3.0));
  vec2 away = texcoord - 0.5;
  return vec3(texture(picture, 0.5 + away * factor.r).r, texture(picture, 0.5 + away * factor.g).g,
              texture(picture, 0.5 + away * factor.b).b);
  // --- skeleton
  // | return texture(picture, texcoord).rgb;
  // <<< student
}

// ---------------------------------------------------------------------------------------------------------------------
// Further: from the scene to the picture
// ---------------------------------------------------------------------------------------------------------------------

// (further) The inverse of fisheye_direction: the texture coordinates where a direction (of any length from
// 1e-12 to 1e12) is seen; beyond the circle too. Straight behind the eye, any place at the distance of this angle.
// Small angles keep their accuracy: a direction 0.001 degrees from the axis is not at the centre. Handout, section 9.
vec2 fisheye_place(vec3 direction, vec2 size, float half_angle) {
  // >>> student: an angle of any size
  float across = length(direction.xy);
  vec2 way = across > 0.0 ? direction.xy / across : vec2(direction.z > 0.0 ? 1.0 : 0.0, 0.0);
  vec2 place = way * (atan(across, -direction.z) / half_angle);
  return 0.5 + 0.5 * place * vec2(size.y / size.x, 1.0);
  // --- skeleton
  // | return vec2(0.5);
  // <<< student
}

// (further) The inverse of power_source: the texture coordinates whose colour comes from `source`, up to 20 half
// heights from the centre, for all strengths from 0 to 10 and powers from 1 to 8, to 1e-5 of the distance or 1e-6,
// whichever is more. Handout, section 9.
vec2 power_place(vec2 source, vec2 size, float strength, float power) {
  // >>> student: a root
  vec2 from_centre = source - 0.5;
  float wanted = length(from_centre * vec2(2.0 * size.x / size.y, 2.0));
  if (wanted == 0.0 || strength == 0.0) return source;
  // r + strength r^(power + 1) is convex, so that Newton's steps from above never go below the root.
  float r = min(wanted, pow(wanted / strength, 1.0 / (power + 1.0)));
  for (int i = 0; i < 8; ++i) {
    float bent = strength * pow(r, power);
    r -= (r + r * bent - wanted) / (1.0 + (power + 1.0) * bent);
  }
  return 0.5 + from_centre * (r / wanted);
  // --- skeleton
  // | return source;
  // <<< student
}

// ---------------------------------------------------------------------------------------------------------------------
// Challenge: relief behind a lens
// ---------------------------------------------------------------------------------------------------------------------

// (challenge) A normal map is seen through a lens: it is the relief of a height field h(source), a height for each
// place of the picture, and what is seen is the relief h(source(place)). `normal` is the unit normal of the first one,
// with z above 0 (z is towards the viewer); the result is the unit normal of the second. jacobian[i] is the derivative
// of `source` by component i of `place`. Handout, section 10.
vec3 distorted_normal(vec3 normal, mat2 jacobian) {
  // >>> student: the slopes of a function of a function
  return normalize(vec3(normal.xy * jacobian, normal.z));
  // --- skeleton
  // | return normal;
  // <<< student
}
