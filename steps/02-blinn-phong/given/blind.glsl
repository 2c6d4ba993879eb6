// The fraction of each light that passes the blind in front of it: BlindShape in blind.hpp. Given. World space, metres.
#include "02-blinn-phong/given/lights.glsl"

uniform float u_blind_below, u_blind_height, u_blind_period, u_blind_ramp;

// The fraction of light that passes the blind at this x.
float through_blind(float x) {
  float off_middle = abs(fract(x / u_blind_period) - 0.5) * u_blind_period;  // distance from the middle of a slat
  float edge = 0.25 * u_blind_period;
  return 0.5 + 0.5 * smoothstep(edge - 0.5 * u_blind_ramp, edge + 0.5 * u_blind_ramp, off_middle);
}

float through_blind_below(vec3 light_position, vec3 position) {
  float fall = light_position.y - position.y;
  return fall > u_blind_below ? through_blind(mix(light_position.x, position.x, u_blind_below / fall)) : 1.0;
}

float point_light_through_blind(int light, vec3 position, vec3 normal, vec3 to_light) {
#if POINT_LIGHTS > 0
  return through_blind_below(u_point_lights[light].position, position);
#else
  return 1.0;
#endif
}

float spot_light_through_blind(int light, vec3 position, vec3 normal, vec3 to_light) {
#if SPOT_LIGHTS > 0
  return through_blind_below(u_spot_lights[light].position, position);
#else
  return 1.0;
#endif
}

float directional_light_through_blind(int light, vec3 position, vec3 normal, vec3 to_light) {
  float climb = u_blind_height - position.y;
  return climb * to_light.y > 0.0 ? through_blind(position.x + to_light.x * climb / to_light.y) : 1.0;
}
