// Hands a surface point to the student's functions. Given.
#include "02-blinn-phong/surface_lighting.glsl"
#include "03-shadow-mapping/shadow_mapping.glsl"

// Which of u_shadow_lights a light is; -1: it has no map.
#if SPOT_LIGHTS > 0
uniform int u_spot_maps[SPOT_LIGHTS];
#endif
#if DIRECTIONAL_LIGHTS > 0
uniform int u_sun_maps[DIRECTIONAL_LIGHTS];
#endif

#if POINT_LIGHTS > 0
uniform int u_point_maps[POINT_LIGHTS];  // of lamps whose casters fit one map: step 04
#endif

float factor_of_map(int map, vec3 position, vec3 normal, vec3 to_light) {
#if SHADOW_LIGHTS > 0
  if (map >= 0) return shadow_factor(u_shadow_lights[map], position, normal, to_light);
#endif
  return 1.0;
}

float spot_visibility(int light, vec3 position, vec3 normal, vec3 to_light) {
#if SPOT_LIGHTS > 0
  return factor_of_map(u_spot_maps[light], position, normal, to_light);
#else
  return 1.0;
#endif
}

float sun_visibility(int light, vec3 position, vec3 normal, vec3 to_light) {
#if DIRECTIONAL_LIGHTS > 0
  return factor_of_map(u_sun_maps[light], position, normal, to_light);
#else
  return 1.0;
#endif
}

float point_visibility_by_map(int light, vec3 position, vec3 normal, vec3 to_light) {
#if POINT_LIGHTS > 0
  return factor_of_map(u_point_maps[light], position, normal, to_light);
#else
  return 1.0;
#endif
}

vec3 shade_shadowed_surface(Surface surface) {
  return u_emission +
         shade_with_shadows(surface.position_world, surface.normal_world, surface.eye_world, material_at(surface));
}

// ---- Intermediates: of the light that shadow.light chooses

uniform int u_shown_map;        // which of u_shadow_lights, or -1
uniform vec3 u_shown_position;  // of the light
uniform vec3 u_shown_direction; // towards it, where it is a sun; else zero

vec3 unit_or_zero(vec3 v) {
  float length_squared = dot(v, v);
  return length_squared > 0.0 ? v * inversesqrt(length_squared) : vec3(0.0);
}

vec3 shown_shadow_factor(Surface surface) {
  vec3 position = surface.position_world, to_light = u_shown_direction;
  if (to_light == vec3(0.0)) to_light = unit_or_zero(u_shown_position - position);
  return vec3(factor_of_map(u_shown_map, position, unit_or_zero(surface.normal_world), to_light));
}

vec3 shown_shadow_coordinate(Surface surface) {
#if SHADOW_LIGHTS > 0
  if (u_shown_map >= 0) return shadow_coordinate(u_shadow_lights[u_shown_map].world_to_map, surface.position_world);
#endif
  return vec3(0.0);
}
