// 09-dithering: what a pixel shader does. The contract of each function is the comment above it.

// ---------------------------------------------------------------------------------------------------------------------
// Core 1: a matrix of thresholds
// ---------------------------------------------------------------------------------------------------------------------

// The threshold of a rank, one of the whole numbers 0 .. count - 1: the middle of the part of 0..1 that belongs to it
// when all ranks get equal parts in their order. Handout, section 2.
float threshold_of(float rank, float count) {
  // >>> student: the middle of a part
  return (rank + 0.5) / count;
  // --- skeleton
  // | return 0.5;
  // <<< student
}

// The number of the level, 0 .. levels - 1, that stands for a value at a threshold, which is above 0 and below 1. A
// level's own value becomes this level. Any other value is on the way from one level to the next: it becomes the upper
// one if it has come further on this way, as a part of it, than the threshold says; if they are equal, either. Values
// below 0 are taken as 0, above 1 as 1. Handout, section 2.
// Five levels, 0.6: 0.4 of the way from level 2 to level 3. It is level 3 at a threshold of 0.3, and level 2 at 0.5.
float level_of(float value, float threshold, float levels) {
  // >>> student: how far is it, in levels?
  return min(floor(clamp(value, 0.0, 1.0) * (levels - 1.0) + 1.0 - threshold), levels - 1.0);
  // --- skeleton
  // | return 0.0;
  // <<< student
}

// ---------------------------------------------------------------------------------------------------------------------
// Core 3: one bit for each pixel
// ---------------------------------------------------------------------------------------------------------------------

// The place on a cube around the eye that is seen in a direction (of any length above 0). x and y run from -1 to 1
// across the face and are proportional to the angle from its middle. z is the number of the face: 0 for +x, 1 -x, 2 +y,
// 3 -y, 4 +z, 5 -z. x is along the axis after the face's own, y along the one after that, in the order x, y, z, x, y;
// both grow with the direction's own component, on opposite faces alike. On an edge any of its faces is right. Handout,
// section 4.
// (2, 1, -0.5) is on face 0, at x = 0.5903 (26.57 of 45 degrees) and y = -0.3119.
vec3 cube_place(vec3 direction) {
  // >>> student: the face, then two angles
  vec3 size = abs(direction);
  int axis = size.x >= max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
  vec2 ratio = vec2(direction[(axis + 1) % 3], direction[(axis + 2) % 3]) / size[axis];
  const float eighth = 0.78539816339744831;
  return vec3(atan(ratio) / eighth, float(2 * axis) + (direction[axis] < 0.0 ? 1.0 : 0.0));
  // --- skeleton
  // | return vec3(0.0);
  // <<< student
}

// Whether a line is drawn between two neighbouring pixels. They show the points a and b, where the surface has the unit
// normals normal_a and normal_b; `nearest` is the distance from the eye to the nearer point, metres. There is a line
// where the normals differ by more than 30 degrees. There is also one where b is away from the tangent plane at a, and
// a from the tangent plane at b, both by more than 1 % of the distance. Handout, section 4.
bool edge_between(vec3 a, vec3 normal_a, vec3 b, vec3 normal_b, float nearest) {
  // >>> student: a bend, or a step
  bool bends = dot(normal_a, normal_b) < 0.86602540378;
  float from_a = abs(dot(normal_a, b - a)), from_b = abs(dot(normal_b, a - b));
  return bends || min(from_a, from_b) > 0.01 * nearest;
  // --- skeleton
  // | return false;
  // <<< student
}

// ---------------------------------------------------------------------------------------------------------------------
// Challenge: a pattern on the world
// ---------------------------------------------------------------------------------------------------------------------

// (challenge) Which cells are mixed at a place where cells of `size` metres would look right. There are squares of 2^k
// metres for each whole number k. x is the least k whose squares are larger than `size`. y, from 0 to 1, is how much of
// the next larger squares is mixed in. At the least `size` for which k is the least, y is 0; it grows evenly with the
// logarithm of `size`, towards 1 where squares of 2^k metres are no longer larger. At a power of two (k, 1) is as right
// as (k + 1, 0). Handout, section 7.
// At 0.3 m squares of 2^-1 m are the least: (-1, 0.263).
vec2 octave_of(float size) {
  // >>> student: the logarithm, in two parts
  float octaves = log2(size);
  return vec2(floor(octaves) + 1.0, octaves - floor(octaves));
  // --- skeleton
  // | return vec2(0.0);
  // <<< student
}

// (challenge) The place of a point in the plane of two world axes that the surface faces most: the component of the
// position that belongs to the normal's largest component (without its sign) is left out, and the two others follow in
// the order x, y, z, x: (y, z), (z, x) or (x, y). Where components are equal, any of them. Handout, section 7.
vec2 surface_place(vec3 position, vec3 normal) {
  // >>> student: which axis is left out?
  vec3 size = abs(normal);
  return size.x >= max(size.y, size.z) ? position.yz : size.y >= size.z ? position.zx : position.xy;
  // --- skeleton
  // | return vec2(0.0);
  // <<< student
}

// (challenge) One threshold of two, a and b, which are independent of each other and each even over 0..1. The result is
// even over 0..1 too, grows with each of them, depends on (1 - part) * a + part * b alone, and is a where part is 0, b
// where it is 1. part is 0..1. Handout, section 7.
float mixed_threshold(float a, float b, float part) {
  // >>> student: how often is the mean of two below this one?
  float mean = mix(a, b, part), less = min(part, 1.0 - part), more = 1.0 - less;
  float low = min(mean, 1.0 - mean);
  float below = low < less ? low * low / (2.0 * less * more) : (low - 0.5 * less) / more;
  return mean < 0.5 ? below : 1.0 - below;
  // --- skeleton
  // | return a;
  // <<< student
}
