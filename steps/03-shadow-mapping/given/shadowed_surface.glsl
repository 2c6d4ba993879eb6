// Hands a surface point to the student's functions. Given.
#include "03-shadow-mapping/shadow_mapping.glsl"

// PARALLEL: in all matrices of suns the last row is 0 0 0 1, as it must be without a perspective.
//
// Which of u_shadow_lights a light is, -1: it has no map. Constants, because what the compiler knows it need not work
// out for every pixel: which light's numbers to fetch, which layer to look up, whether there is a perspective.
#if SPOT_LIGHTS > 0
const int spot_maps[SPOT_LIGHTS] = int[](SPOT_MAPS);
#endif
#if DIRECTIONAL_LIGHTS > 0
const int directional_maps[DIRECTIONAL_LIGHTS] = int[](DIRECTIONAL_MAPS);
#endif
#if POINT_LIGHTS > 0
const int point_maps[POINT_LIGHTS] = int[](POINT_MAPS);  // of lamps whose casters fit one map: step 04
#endif

float factor_of_map(int map, bool sun, vec3 position, vec3 normal, vec3 to_light) {
#if SHADOW_LIGHTS > 0
  if (map >= 0) {
    ShadowLight light = u_shadow_lights[map];
    light.layer = map;
    light.sun = sun;
#ifdef PARALLEL
    if (sun) {
      mat4 m = light.world_to_map;
      light.world_to_map = mat4(vec4(m[0].xyz, 0.0), vec4(m[1].xyz, 0.0), vec4(m[2].xyz, 0.0), vec4(m[3].xyz, 1.0));
    }
#endif
    return shadow_factor(light, position, normal, to_light);
  }
#endif
  return 1.0;
}

float spot_visibility_by_map(int light, vec3 position, vec3 normal, vec3 to_light) {
#if SPOT_LIGHTS > 0
  return factor_of_map(spot_maps[light], false, position, normal, to_light);
#else
  return 1.0;
#endif
}

float directional_visibility_by_map(int light, vec3 position, vec3 normal, vec3 to_light) {
#if DIRECTIONAL_LIGHTS > 0
  return factor_of_map(directional_maps[light], true, position, normal, to_light);
#else
  return 1.0;
#endif
}

float point_visibility_by_map(int light, vec3 position, vec3 normal, vec3 to_light) {
#if POINT_LIGHTS > 0
  return factor_of_map(point_maps[light], false, position, normal, to_light);
#else
  return 1.0;
#endif
}

// ---- Intermediates: of the light that shadow.light chooses, whose map is SHOWN_MAP (-1: none)

#ifdef SHOWN_MAP
uniform vec3 u_shown_position;   // of the light
uniform vec3 u_shown_direction;  // towards it, where it is a sun; else zero

vec3 unit_or_zero(vec3 v) {
  float length_squared = dot(v, v);
  return length_squared > 0.0 ? v * inversesqrt(length_squared) : vec3(0.0);
}

vec3 shown_shadow_factor(Surface surface) {
  vec3 position = surface.position_world, to_light = u_shown_direction;
  bool sun = to_light != vec3(0.0);
  if (!sun) to_light = unit_or_zero(u_shown_position - position);
  return vec3(factor_of_map(SHOWN_MAP, sun, position, unit_or_zero(surface.normal_world), to_light));
}

vec3 shown_shadow_coordinate(Surface surface) {
#if SHADOW_LIGHTS > 0
  if (SHOWN_MAP >= 0) return shadow_coordinate(u_shadow_lights[SHOWN_MAP].world_to_map, surface.position_world);
#endif
  return vec3(0.0);
}
#endif
