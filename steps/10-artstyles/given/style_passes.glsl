// What the passes of this step do to a pixel, with the student's functions. Given.
#include "10-artstyles/artstyles.glsl"

uniform float u_half_height;  // of the picture, 1 m ahead of the eye
uniform float u_half_angle, u_strength, u_power;

vec2 half_size() { return u_half_height * vec2(u_size.x / u_size.y, 1.0); }
vec2 pixel_size() { return 1.0 / u_size; }
bool in_picture(vec2 texcoord) {
  return all(greaterThanEqual(texcoord, vec2(0.0))) && all(lessThanEqual(texcoord, vec2(1.0)));
}

// Where the lens takes a pixel from, in texture coordinates; outside the picture: nowhere.
vec2 lens_source(vec2 texcoord) {
#ifdef EQUIDISTANT
  vec3 direction = fisheye_direction(texcoord, u_size, u_half_angle);
  return direction.z < 0.0 ? 0.5 + 0.5 * direction.xy / -direction.z / half_size() : vec2(-1.0);
#else
  return power_source(texcoord, u_size, u_strength, u_power);
#endif
}

// Where a map is looked up that may be seen through the lens; false where the lens shows nothing of it.
bool map_source(vec2 texcoord, out vec2 source) {
#ifdef BEHIND_LENS
  source = lens_source(texcoord);
  return in_picture(source);
#else
  source = texcoord;
  return true;
#endif
}

// ---- Surfaces

#ifdef SURFACES
uniform vec3 u_eye_of_view, u_ahead;

// The normal and 1/depth in a pixel, all 0 where nothing is seen.
vec4 surface_at(vec2 texcoord) {
  vec2 source;
  if (!map_source(texcoord, source)) return vec4(0.0);
  vec3 code = texture(u_normal, source).rgb;
  if (code == vec3(0.0)) return vec4(0.0);
  float depth = dot(texture(u_position, source).rgb - u_eye_of_view, u_ahead);
  return vec4(normalize(2.0 * code - 1.0), 1.0 / depth);
}

vec4 surface_beside(vec2 texcoord, float columns, float rows) {
  vec2 neighbour = texcoord + vec2(columns, rows) * pixel_size();
  return surface_at(clamp(neighbour, 0.5 * pixel_size(), 1.0 - 0.5 * pixel_size()));
}

vec2 steps_at(vec2 at) {
  return surface_steps(vec4[9](surface_beside(at, -1.0, 1.0), surface_beside(at, 0.0, 1.0), surface_beside(at, 1.0, 1.0),
                               surface_beside(at, -1.0, 0.0), surface_at(at), surface_beside(at, 1.0, 0.0),
                               surface_beside(at, -1.0, -1.0), surface_beside(at, 0.0, -1.0),
                               surface_beside(at, 1.0, -1.0)));
}

vec4 steps_pass(vec2 texcoord) { return vec4(steps_at(texcoord), 0.0, 1.0); }
#endif

// ---- Styles

vec4 edges_pass(vec2 texcoord) {
  return vec4(vec3(edge_strength(u_picture, texcoord, pixel_size()) / 4.472135955), 1.0);
}

#ifdef TOON
uniform float u_low, u_high;
vec4 toon_pass(vec2 texcoord) {
  vec4 c = texture(u_picture, texcoord);
  float edge = 0.0;
#ifdef COLOUR_EDGES
  edge = edge_strength(u_picture, texcoord, pixel_size());
#endif
  vec3 drawn = toon(c.rgb, edge, u_low, u_high);
#ifdef SURFACES
  vec2 steps = steps_at(texcoord);
  drawn *= 1.0 - max(smoothstep(0.02, 0.05, steps.x), smoothstep(0.35, 0.6, steps.y));
#endif
  return vec4(drawn, c.a);
}
#endif

vec4 fisheye_pass(vec2 texcoord) {
#ifdef EQUIDISTANT
  return vec4(colour_in_direction(u_picture, fisheye_direction(texcoord, u_size, u_half_angle), half_size()), 1.0);
#else
  vec2 source = lens_source(texcoord);
  return vec4(in_picture(source) ? texture(u_picture, source).rgb : vec3(0.0), 1.0);
#endif
}

#ifdef CUBE
uniform samplerCube u_cube;  // in the directions of view space
vec4 cube_pass(vec2 texcoord) {
  vec3 direction = fisheye_direction(texcoord, u_size, u_half_angle);
  return vec4(direction == vec3(0.0) ? vec3(0.0) : texture(u_cube, direction).rgb, 1.0);
}
#endif

// The lens undone: what was seen through it, where it belongs.
vec4 restored_pass(vec2 texcoord) {
#ifdef EQUIDISTANT
  vec3 direction = vec3((2.0 * texcoord - 1.0) * half_size(), -1.0);
  vec2 place = fisheye_place(direction, u_size, u_half_angle);
  if (length((2.0 * place - 1.0) * vec2(u_size.x / u_size.y, 1.0)) > 1.0) return vec4(vec3(0.0), 1.0);
#else
  vec2 place = power_place(texcoord, u_size, u_strength, u_power);
#endif
  return vec4(in_picture(place) ? texture(u_picture, place).rgb : vec3(0.0), 1.0);
}

uniform float u_amount, u_turns;
vec4 aberration_pass(vec2 texcoord) {
  return vec4(aberrated(u_picture, texcoord, u_amount, u_turns), 1.0);
}

// ---- The picture's relief

#ifdef RELIEF
uniform mat3 u_world_to_view;

// The derivatives of the lens, in half heights: the mean of the differences to both sides, or the one to the inner side
// where the lens shows nothing on the other.
mat2 lens_jacobian(vec2 texcoord) {
  const float h = 0.001;
  vec2 half_height = 0.5 * vec2(u_size.y / u_size.x, 1.0);  // in texture coordinates
  vec2 here = lens_source(texcoord);
  mat2 jacobian;
  for (int i = 0; i < 2; ++i) {
    vec2 offset = vec2(i == 0 ? h : 0.0, i == 1 ? h : 0.0) * half_height;
    vec2 after = lens_source(texcoord + offset), before = lens_source(texcoord - offset);
    if (after == vec2(-1.0)) after = 2.0 * here - before;
    if (before == vec2(-1.0)) before = 2.0 * here - after;
    jacobian[i] = (after - before) / (2.0 * h * half_height);
  }
  return jacobian;
}

vec4 relief_pass(vec2 texcoord) {
  vec2 source;
  if (!map_source(texcoord, source)) return vec4(0.0, 0.0, 0.0, 1.0);
  vec3 code = texture(u_normal, source).rgb;
  if (code == vec3(0.0)) return vec4(0.0, 0.0, 0.0, 1.0);
  vec3 normal = u_world_to_view * (2.0 * code - 1.0);
  // A height field has no overhangs, which a picture in perspective may show.
  normal = normalize(vec3(normal.xy, max(normal.z, 0.01)));
#ifdef BEHIND_LENS
  normal = distorted_normal(normal, lens_jacobian(texcoord));
#endif
  return vec4(0.5 * normal + 0.5, 1.0);
}
#endif
