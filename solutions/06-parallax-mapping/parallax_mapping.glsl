// 06-parallax-mapping, for every pixel: where does the ray from the eye meet the relief? The contract of a function is
// the comment above it.
//
// The relief lies below the surface. In texture coordinates it is a height field: float height_at(vec2 texcoord), 0 to
// 1, is given in the file included below. It may be called anywhere, also in loops and branches. Height 1 is the
// surface itself, height 0 is the deepest level, `depth` below it (as a fraction of the texture's side, like the depth
// of step 05's height maps); the functions that need it have it as a parameter. A ray enters at (texcoord, height 1)
// and reaches height 0 at texcoord + span. A point of the ray is named by t, 0 to 1, the fraction of this way: its
// texture coordinate is texcoord + t span, its height 1 - t.
#include "06-parallax-mapping/given/relief.glsl"

// ---- The ray

// The way in texture coordinates that a ray takes from height 1 to height 0, away from the eye. `to_eye` is the unit
// vector to the eye in tangent space: x along u, y along v, z away from the surface. z counts as at least 0.05, also
// where it is negative, so that the way is at most 20 depths. (0, 0) for a vector with a NaN. Handout, section 1.
// to_eye = (0.6, 0, 0.8), depth 0.04: (-0.03, 0).
vec2 parallax_span(vec3 to_eye, float depth) {
  // >>> student: away from the eye, the farther the flatter the view
  if (any(isnan(to_eye))) return vec2(0.0);
  return -to_eye.xy / max(to_eye.z, 0.05) * depth;
  // --- skeleton
  // | return vec2(0.0);
  // <<< student
}

// Parallax mapping with one lookup (Kaneko et al. 2001): t of the point where the ray has the height of the relief at
// `texcoord`, as if the relief were flat around it. Handout, section 2.
float offset_hit(vec2 texcoord) {
  // >>> student: the depth of the relief right here
  return 1.0 - height_at(texcoord);
  // --- skeleton
  // | return 0.0;
  // <<< student
}

// ---- Marching

// The first of `layers` equal steps down the ray that ends in the relief: the ray is cut at t = 0, 1/layers, 2/layers,
// ... 1, and the answer is the interval (t before, t after) of the first step whose end has a height of at most that of
// the relief there. (0, 0) where the relief is at least 1 high at `texcoord` already. layers >= 1. As no relief is below
// 0, the last step always ends in it. Handout, section 3. You may call: height_at.
vec2 first_step_below(vec2 texcoord, vec2 span, int layers) {
  // >>> student: step down until the ray is in the relief
  if (height_at(texcoord) >= 1.0) return vec2(0.0);
  for (int i = 1; i < layers; ++i) {
    float t = float(i) / float(layers);
    if (1.0 - t <= height_at(texcoord + t * span)) return vec2(float(i - 1) / float(layers), t);
  }
  return vec2(float(layers - 1) / float(layers), 1.0);
  // --- skeleton
  // | return vec2(0.0);
  // <<< student
}

// Parallax occlusion mapping: t of the point of an interval (t before, t after) at which the ray meets the straight line
// between the heights of the relief at both ends (one step of the secant method). At its begin the ray is above the
// relief, at its end below it or on it; where it is on it at both ends, the begin. Handout, section 4. You may call:
// height_at.
float secant_hit(vec2 texcoord, vec2 span, vec2 interval) {
  // >>> student: two similar triangles
  float above = 1.0 - interval.x - height_at(texcoord + interval.x * span);
  float below = height_at(texcoord + interval.y * span) - (1.0 - interval.y);
  float both = above + below;
  return both > 0.0 ? mix(interval.x, interval.y, above / both) : interval.x;
  // --- skeleton
  // | return interval.y;
  // <<< student
}

// (further) Relief mapping (Policarpo et al. 2005): an interval (t before, t after) whose begin is above the relief and
// whose end is in it. It is halved `bisections` times, and the same must stay true; a middle that is on the relief counts
// as in it. The answer is the middle of what is left; with 0 bisections that of the whole. Handout, section 5. You may
// call: height_at.
float bisected_hit(vec2 texcoord, vec2 span, vec2 interval, int bisections) {
  // >>> student: which half?
  for (int i = 0; i < bisections; ++i) {
    float middle = 0.5 * (interval.x + interval.y);
    if (1.0 - middle <= height_at(texcoord + middle * span))
      interval.y = middle;
    else
      interval.x = middle;
  }
  return 0.5 * (interval.x + interval.y);
  // --- skeleton
  // | return interval.y;
  // <<< student
}

// How many layers a pixel needs: one for each pixel that the ray crosses on the screen, rounded up, at least 1 and at
// most `most`. dx and dy are the changes of the texture coordinate to the neighbouring pixel on the right and above, so
// span = x dx + y dy says how many pixels it crosses: the length of (x, y). `most` where dx and dy are zero or parallel
// (the absolute value of their determinant is at most 1e-6 |dx| |dy|). Handout, section 6.
// dx = (0.01, 0), dy = (0, 0.02), span = (0.03, 0.08): (3, 4), so 5.
int layers_needed(vec2 span, vec2 dx, vec2 dy, int most) {
  // >>> student: the span in pixels
  float determinant = dx.x * dy.y - dx.y * dy.x;
  if (abs(determinant) <= 1e-6 * length(dx) * length(dy)) return most;
  vec2 pixels = vec2(span.x * dy.y - span.y * dy.x, dx.x * span.y - dx.y * span.x) / determinant;
  return int(clamp(ceil(length(pixels)), 1.0, float(most)));
  // --- skeleton
  // | return 1;
  // <<< student
}

// ---- Light

// (further) Whether the relief hides a light: 1 where the point is lit, 0 where it is in the shadow of the relief. The
// point of the relief has the coordinate `texcoord` and the height `height`. light_span is the way in texture
// coordinates that the ray to the light takes from height 0 to height 1. The rest of the ray, from `height` up to 1, is
// cut into `samples` equal steps; the point is in shadow if at the end of any step but the last the relief is higher
// than the ray by more than 0.001. samples >= 1; with 1 it is always lit. Handout, section 7. You may call: height_at.
float relief_visibility(vec2 texcoord, float height, vec2 light_span, int samples) {
  // >>> student: climb towards the light
  for (int i = 1; i < samples; ++i) {
    float rise = (1.0 - height) * float(i) / float(samples);
    if (height_at(texcoord + rise * light_span) > height + rise + 0.001) return 0.0;
  }
  return 1.0;
  // --- skeleton
  // | return 1.0;
  // <<< student
}

// ---- Where the relief is

// The world position of the point of the relief, so that lights, shadows and other objects find it there: on the line
// from the eye through `position`, a point of the surface, farther away. The deepest level of the relief is `metres`
// below the surface; to_eye is the unit vector to the eye in tangent space, whose z counts as in parallax_span. Where the
// eye is at `position`, the position. Handout, section 8.
vec3 relief_position(vec3 position, vec3 eye, vec3 to_eye, float metres, float t) {
  // >>> student: how long is the ray between the surface and a level below it?
  vec3 way = position - eye;
  float size = length(way);
  return size > 0.0 ? position + way / size * (t * metres / max(to_eye.z, 0.05)) : position;
  // --- skeleton
  // | return position;
  // <<< student
}

// (further) The depth of a world position in the depth buffer, 0 to 1, what OpenGL computes for a vertex there: for
// gl_FragDepth. Handout, section 8.
float depth_of(mat4 world_to_clip, vec3 position) {
  // >>> student: clip space, -1..1, 0..1
  vec4 clip = world_to_clip * vec4(position, 1.0);
  return 0.5 * clip.z / clip.w + 0.5;
  // --- skeleton
  // | return gl_FragCoord.z;
  // <<< student
}

// (further) Whether a texture coordinate is outside of the rectangle from `low` to `high`, so that the ray has left the
// relief through a side. Its edge belongs to the rectangle. Handout, section 8.
bool beyond_edges(vec2 texcoord, vec2 low, vec2 high) {
  // >>> student: any side
  return any(lessThan(texcoord, low)) || any(greaterThan(texcoord, high));
  // --- skeleton
  // | return false;
  // <<< student
}

// ---- The outline of a curved surface

// (challenge) How much a ray bends against a curved surface. At the distance s along its tangent plane, in metres, a
// surface of the curvature k is k s^2 / 2 below this plane: k > 0 where it is convex, k < 0 where it is concave, 1/m.
// So a ray has at t the height 1 - t + bend t^2 above the deepest level; `bend` is the answer. `span` and `depth` as in
// parallax_span, depth > 0; `metres` is the length of the texture's side. Handout, section 10.
// span = (0.3, 0.4), depth 0.1, metres 2, curvature 0.5: 1 m along, 0.2 m down, the surface 0.25 m down, so 1.25.
float ray_bend(vec2 span, float depth, float metres, float curvature) {
  // >>> student: how far the surface falls on the way of the span, in depths of the relief
  return 0.5 * curvature * dot(span, span) * metres / depth;
  // --- skeleton
  // | return 0.0;
  // <<< student
}

// (challenge) t at which the search along such a ray ends: the smallest t > 0 at which it has height 0 or, if there is
// none, at which it has height 1 and leaves the relief. For any bend, with the same relative error near 0 as elsewhere.
// Handout, section 10.
// bend = 0: 1. bend = -2: 0.5. bend = 0.25: 2. bend = 0.5: 2, where it leaves.
float ray_end(float bend) {
  // >>> student: the smaller root, without a difference of nearly equal numbers; or the way out
  return bend <= 0.25 ? 2.0 / (1.0 + sqrt(1.0 - 4.0 * bend)) : 1.0 / bend;
  // --- skeleton
  // | return 1.0;
  // <<< student
}

// (challenge) t of the point where such a ray meets the relief, or -1 where it leaves the relief without having met it.
// 0 where the relief is at least 1 high at `texcoord` already. Otherwise the ray is cut into `layers` equal steps from
// t = 0 to ray_end(bend), and the first step counts whose end has a height of at most that of the relief there. The
// answer is the point in it at which the difference of both heights would be zero if it changed evenly, as in
// secant_hit. The last step of a ray that reaches height 0 always ends in the relief, that of a ray that leaves never,
// whatever the height of the relief there. layers >= 1. Handout, section 10. You may call: height_at, ray_end.
float curved_hit(vec2 texcoord, vec2 span, float bend, int layers) {
  // >>> student: the march and the secant, with the height of the bent ray
  float before = 0.0, above = 1.0 - height_at(texcoord), end = ray_end(bend);
  if (above <= 0.0) return 0.0;
  for (int i = 1; i < layers; ++i) {
    float t = end * float(i) / float(layers);
    float still_above = 1.0 - t + bend * t * t - height_at(texcoord + t * span);
    if (still_above <= 0.0) return mix(before, t, above / (above - still_above));
    before = t;
    above = still_above;
  }
  if (bend > 0.25) return -1.0;
  return mix(before, end, above / (above + height_at(texcoord + end * span)));
  // --- skeleton
  // | return 0.0;
  // <<< student
}

// ---- A map of a rendered scene

// The height of a pixel of a picture that serves as a height map of what it shows: 1 at the distance `nearest` in front
// of the camera, 0 at `farthest`, in between in proportion, never outside of 0 to 1. `position` is in view space: the
// camera looks along -z. 0 <= nearest < farthest, metres. Handout, section 9.
float recorded_height(vec3 position, float nearest, float farthest) {
  // >>> student: linear in the distance along the view direction
  return clamp((farthest + position.z) / (farthest - nearest), 0.0, 1.0);
  // --- skeleton
  // | return 1.0;
  // <<< student
}
