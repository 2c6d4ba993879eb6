// 08-post-processing: what each pass does to a pixel. The contract of each function is the comment above it. All
// colours are linear light with the primaries of Rec. 709, finite and at least 0; before tone mapping they may be above
// 1.
//
// Given, in the file included below: float u_weights[LAST_WEIGHT + 1], with LAST_WEIGHT at least 0; float u_table_size.
#include "08-post-processing/given/post_inputs.glsl"

// ---------------------------------------------------------------------------------------------------------------------
// Core 1: the chain
// ---------------------------------------------------------------------------------------------------------------------

// The corners 0, 1 and 2 of a triangle that covers the whole picture, in normalised device coordinates (x and y of clip
// space with w = 1), counter-clockwise. Handout, section 1.
vec2 full_screen_corner(int corner) {
  // TODO(08-post-processing): three corners
  return vec2(0.0);
}

// ---------------------------------------------------------------------------------------------------------------------
// Core 2: hue, chroma, luma
// ---------------------------------------------------------------------------------------------------------------------

// The luma of a colour: how bright it is, 0.2126 r + 0.7152 g + 0.0722 b (the luminance of linear Rec. 709).
float luma(vec3 colour) {
  // TODO(08-post-processing): three weights
  return 0.0;
}

// Hue, chroma and luma of a colour. Chroma is the largest component minus the smallest. Hue is an angle in turns, from
// 0 to 1: red is 0, yellow 1/6, green 1/3, cyan 1/2, blue 2/3, magenta 5/6, and between two of these it is proportional
// to the component that changes (the hue of HSV). A grey has the hue 0. Handout, section 3.
// (0.5, 0.25, 0) has the hue 1/12, the chroma 0.5, and the luma 0.2851.
vec3 hue_chroma_luma(vec3 colour) {
  // TODO(08-post-processing): which component is the largest, and where between its neighbours is the colour?
  return vec3(0.0, 0.0, luma(colour));
}

// The colour that has this hue (in turns; whole turns more or less change nothing) and this luma (at least 0), and the
// greatest chroma up to the given one with which no component is below 0 or above 1; a luma of 1 or more gives a grey.
// Handout, section 3.
// Hue 1/12, luma 0.2851: with chroma 0.5 it is (0.5, 0.25, 0). With chroma 0.8 it is the same: more chroma would need
// less than no blue.
vec3 colour_of(float hue, float chroma, float luma_wanted) {
  // TODO(08-post-processing): which colour has this hue, and how much of it fits?
  return vec3(luma_wanted);
}

// A colour with its hue turned by `turns`, its chroma times `saturation`, and its luma times `brightness`; each of the
// two is at least 0. Handout, section 3.
vec3 adjusted(vec3 colour, float turns, float saturation, float brightness) {
  // TODO(08-post-processing): there and back
  return colour;
}

// ---------------------------------------------------------------------------------------------------------------------
// Core 3: tone mapping
// ---------------------------------------------------------------------------------------------------------------------

// Reinhard's curve (Reinhard et al. 2002, equation 4) of the luma Y: Y (1 + Y / white^2) / (1 + Y), so that a luma of
// `white` becomes 1. All components are scaled by the same factor; black stays black. Handout, section 4.
vec3 reinhard(vec3 colour, float white) {
  // TODO(08-post-processing): one factor for all components
  return colour;
}

// Hable's filmic curve ("Uncharted 2", 2010), on each component x by itself: h(2 x) / h(11.2), where h(x) = (x (A x + C B)
// + D E) / (x (A x + B) + D F) - E / F with A = 0.15, B = 0.5, C = 0.1, D = 0.2, E = 0.02, F = 0.3. Handout, section 4.
vec3 filmic(vec3 colour) {
  // TODO(08-post-processing): the same curve twice
  return colour;
}

// The light of the scene as a display shows it: multiplied by 2^stops, then by the curve: 0 none, 1 Reinhard's with this
// `white`, 2 filmic. Handout, section 4.
vec3 tone_mapped(vec3 colour, float stops, int curve, float white) {
  // TODO(08-post-processing): expose, then bend
  return colour;
}

// ---------------------------------------------------------------------------------------------------------------------
// Core 4: a picture over the picture
// ---------------------------------------------------------------------------------------------------------------------

// `above` laid over `below`, seen by `amount` (0..1). above.a is the opacity of its colour, 0..1; its colour is not
// multiplied by it. Where amount * above.a is 0 the result is exactly `below`, where it is 1 exactly above.rgb. The
// opacity of the result is that of `below`. Handout, section 5.
vec4 overlaid(vec4 below, vec4 above, float amount) {
  // TODO(08-post-processing): a share of each
  return below;
}

// ---------------------------------------------------------------------------------------------------------------------
// Further: bloom, tables, the bands of 8 bits
// ---------------------------------------------------------------------------------------------------------------------

// (further) The part of a colour that blooms: the same hue, with the luma that exceeds `threshold`; black where none
// does. Handout, section 6.
vec3 bright_part(vec3 colour, float threshold) {
  // TODO(08-post-processing): which share of the light is too much?
  return vec3(0.0);
}

// (further) One direction of a Gaussian blur at texcoord: the sum over k of u_weights[abs(k)] times the picture at k
// steps from there, -LAST_WEIGHT <= k <= LAST_WEIGHT. `pixel` is one step, in texture coordinates. Beyond its edges the
// picture goes on with the colours of its edges: that is given, by its wrap mode. Handout, section 6.
vec3 blurred(sampler2D picture, vec2 texcoord, vec2 pixel) {
  // TODO(08-post-processing): both sides at once
  return texture(picture, texcoord).rgb;
}

// (further) Looks a colour up in a table, trilinearly. The table is a texture of u_table_size grid points a side, filtered
// linearly by the hardware and clamped at its edges; `colour` is 0..1 within the table's range: 0 is at the centre of the
// first texel, 1 at that of the last. Handout, section 7.
vec3 table_trilinear(sampler3D table, vec3 colour) {
  // TODO(08-post-processing): where are the centres of texels?
  return colour;
}

// (further) The same, tetrahedrally (Kasson et al. 1995): in the cell of the grid around the colour, go from its corner
// with the least components to that with the greatest along the edges, in the order of the fractions, the largest first;
// the result is interpolated in this tetrahedron. On greys it interpolates along the cell's diagonal alone. Handout,
// section 7.
vec3 table_tetrahedral(sampler3D table, vec3 colour) {
  // TODO(08-post-processing): three edges, one after another
  return colour;
}

// (further) What is stored in 8 bits in place of a value, so that its mean over many pixels stays: `stored` is 0..1, and
// is rounded to the nearest multiple of 1/255 afterwards: that is given. `noise` is another number in each pixel, and
// uniformly distributed over 0..1; more noise gives more. Handout, section 8.
vec3 dithered(vec3 stored, float noise) {
  // TODO(08-post-processing): half a step up or down
  return stored;
}
