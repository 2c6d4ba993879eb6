// Passes a surface point to the student's functions. Given.
#include "03-shadow-mapping/given/facet_normal.glsl"
#include "03-shadow-mapping/shadow_mapping.glsl"

// PARALLEL: the last row of the matrices of all directional lights is 0 0 0 1, as in every matrix without perspective.
//
// The index of each light in u_shadow_lights; -1: it has no map. These are constants, so that the compiler knows which
// light and which layer are read, and whether there is perspective.
#if SPOT_LIGHTS > 0
const int spot_maps[SPOT_LIGHTS] = int[](SPOT_MAPS);
#endif
#if DIRECTIONAL_LIGHTS > 0
const int directional_maps[DIRECTIONAL_LIGHTS] = int[](DIRECTIONAL_MAPS);
#endif
#if POINT_LIGHTS > 0
const int point_maps[POINT_LIGHTS] = int[](POINT_MAPS);  // of point lights whose casters fit into one map: step 04
#endif

float factor_of_map(int map, bool directional, vec3 position, vec3 normal, vec3 to_light) {
#if SHADOW_LIGHTS > 0
  if (map >= 0) {
    ShadowLight light = u_shadow_lights[map];
    light.layer = map;
    light.directional = directional;
#ifdef PARALLEL
    if (directional) {
      mat4 m = light.world_to_map;
      light.world_to_map = mat4(vec4(m[0].xyz, 0.0), vec4(m[1].xyz, 0.0), vec4(m[2].xyz, 0.0), vec4(m[3].xyz, 1.0));
    }
#endif
    return shadow_factor(light, position, facet_normal(position, normal), to_light);
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

// ---- Intermediate results for the light that shadow.light chooses; SHOWN_MAP is its map (-1: none)

#ifdef SHOWN_MAP
uniform vec3 u_shown_position;   // of the light
uniform vec3 u_shown_direction;  // towards it, of a directional light; otherwise zero

vec3 unit_or_zero(vec3 v) {
  float length_squared = dot(v, v);
  return length_squared > 0.0 ? v * inversesqrt(length_squared) : vec3(0.0);
}

vec3 shown_shadow_factor(Surface surface) {
  vec3 position = surface.position_world, to_light = u_shown_direction;
  bool directional = to_light != vec3(0.0);
  if (!directional) to_light = unit_or_zero(u_shown_position - position);
  return vec3(factor_of_map(SHOWN_MAP, directional, position, unit_or_zero(surface.normal_world), to_light));
}

vec3 shown_shadow_coordinate(Surface surface) {
#if SHADOW_LIGHTS > 0
  if (SHOWN_MAP >= 0) return shadow_coordinate(u_shadow_lights[SHOWN_MAP].world_to_map, surface.position_world);
#endif
  return vec3(0.0);
}
#endif
