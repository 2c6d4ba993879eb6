// Passes a surface point to the student's functions. Given.
#include "03-shadow-mapping/given/facet_normal.glsl"
#include "04-point-shadows/point_shadows.glsl"

// The index of each point light in u_cube_lights; -1: it has no cube map.
#if POINT_LIGHTS > 0
const int point_cubes[POINT_LIGHTS] = int[](POINT_CUBES);
#endif

float factor_of_cube(int cube, vec3 position, vec3 normal, vec3 to_light) {
#if CUBES > 0
  if (cube >= 0) return point_shadow_factor(u_cube_lights[cube], position, facet_normal(position, normal), to_light);
#endif
  return 1.0;
}

float point_visibility_by_cube(int light, vec3 position, vec3 normal, vec3 to_light) {
#if POINT_LIGHTS > 0
  return factor_of_cube(point_cubes[light], position, normal, to_light);
#else
  return 1.0;
#endif
}

// ---- Intermediate results for the light that shadow.light chooses; SHOWN_CUBE is its cube map

#ifdef SHOWN_CUBE
vec3 shown_cube_factor(Surface surface) {
  vec3 position = surface.position_world;
  return vec3(factor_of_cube(SHOWN_CUBE, position, unit_or_zero(surface.normal_world),
                             unit_or_zero(u_shown_position - position)));
}

// The vector from the light to the point, as a fraction of `far`.
vec3 shown_cube_coordinate(Surface surface) {
#if CUBES > 0
  return (surface.position_world - u_cube_lights[SHOWN_CUBE].position) / u_cube_lights[SHOWN_CUBE].far;
#else
  return vec3(0.0);
#endif
}
#endif
