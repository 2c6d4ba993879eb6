// 05-normal-mapping, for every pixel. The contract of a function is the comment above it. Tangent space, tangents and
// the sign w are described in normal_mapping.hpp. Interpolated vectors have any length.

// ---- From a texel to a normal

// The normal in tangent space that the texel c stores, c = n/2 + 1/2, with unit length. Filtering averages texels, so
// the stored vector is in general shorter than 1. Where it is shorter than 0.0001 it has no direction: (0, 0, 1).
// Handout, section 1.
vec3 decode_normal(vec3 c) {
  // TODO(05-normal-mapping): from 0..1 to -1..1, with unit length
  return vec3(0.0, 0.0, 1.0);
}

// The frame of a pixel as the columns T, B, N of a matrix, which takes tangent space to world space: T = tangent.xyz,
// N = normal, B = w cross(N, T), with the sign of tangent.w alone as w (+1 for 0). The vectors are used as they were
// interpolated, without being normalised or made perpendicular: this is what the tools that make normal maps assume
// (Mikkelsen, "Simulation of wrinkled surfaces revisited", 2008). Handout, section 5.
mat3 tangent_frame(vec3 normal, vec4 tangent) {
  // TODO(05-normal-mapping): three columns
  return mat3(vec3(0.0), vec3(0.0), normal);
}

// The normal in world space, of unit length, that `stored` stands for, a unit vector in tangent space. Where
// tangent.xyz is zero there is no frame: the interpolated normal itself, unchanged, so that the surface is shaded as if
// it had no map. Also where the result would have no direction. Handout, section 5. You may call: tangent_frame.
vec3 mapped_normal(vec3 normal, vec4 tangent, vec3 stored) {
  // TODO(05-normal-mapping): from tangent space to world space
  return normal;
}

// ---- A map of a rendered scene

// The colour of a pixel of a picture that serves as a normal map of what it shows: n/2 + 1/2, where n is the normal of
// the surface in view space, of unit length: red is to the right in the picture, green up, blue towards the viewer.
// world_to_view is the rotation of the view matrix. A zero normal becomes the colour of (0, 0, 1). Handout, section 6.
vec3 recorded_normal(mat3 world_to_view, vec3 normal) {
  // TODO(05-normal-mapping): the normal as the camera sees it, as a colour
  return vec3(0.5, 0.5, 1.0);
}

// ---- Tangents without vertices

// (further) The tangent of a pixel from derivatives: how position and texture coordinate change to the neighbouring
// pixel on the right (dx) and above (dy), so that no tangents have to be stored. `normal` has any length. xyz is the
// direction in which u grows, perpendicular to the normal, of unit length; w is the sign with which B = w cross(N, T)
// points to where v grows. (0, 0, 0, 0) where the texture coordinates do not say it: the determinant of texcoord_dx,
// texcoord_dy is at most 1e-6 |texcoord_dx| |texcoord_dy|, or the direction is parallel to the normal, or the normal is
// zero. Handout, section 7.
vec4 derivative_tangent(vec3 normal, vec3 position_dx, vec3 position_dy, vec2 texcoord_dx, vec2 texcoord_dy) {
  // TODO(05-normal-mapping): the direction in which u grows, and the side on which v grows
  return vec4(0.0);
}

// ---- Light in tangent space

// (further) A vector of world space in the tangent space of a pixel: its components along three perpendicular unit
// vectors. The third is along `normal`, the first along the part of tangent.xyz that is perpendicular to it, the second
// is w cross(third, first), with the sign of tangent.w as in tangent_frame. Lighting may then use the stored normal as
// it is: lengths and angles are those of world space. Neither vector is zero, and they are not parallel. Handout,
// section 8.
vec3 to_tangent_space(vec3 normal, vec4 tangent, vec3 v) {
  // TODO(05-normal-mapping): an orthonormal frame; its inverse takes world space to tangent space
  return v;
}

// ---- Filtered normals

// (challenge) The exponent of the highlight where a filtered texel c stands for many normals: the more they differ, the
// shorter their mean, and the wider the highlight of all of them together (Toksvig, "Mipmapping normal maps", 2005):
// n |m| / (|m| + n (1 - |m|)) with the exponent n and the mean m that c stores. |m| counts as at most 1. 0 where |m| is
// 0. Handout, section 9.
float filtered_exponent(float exponent, vec3 c) {
  // TODO(05-normal-mapping): the shorter the mean normal, the wider the highlight
  return exponent;
}
