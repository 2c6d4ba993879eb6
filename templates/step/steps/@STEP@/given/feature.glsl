// Applies the student's fog to the light from a surface. Given.
#include "@STEP@/@NAME@.glsl"

uniform vec3 u_@NAME@_air;
uniform float u_@NAME@_density;  // 1/m
uniform int u_@NAME@_pieces;

vec3 @NAME@_shaded(Surface surface, vec3 shaded) {
  float way = distance(surface.eye_world, surface.position_world);
  return @NAME@_light(shaded, u_@NAME@_air, u_@NAME@_density, way, u_@NAME@_pieces);
}
