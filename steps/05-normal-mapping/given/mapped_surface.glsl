// Applies a normal map to a surface point with the student's functions. Given.
#include "05-normal-mapping/given/surface_tangent.glsl"
#include "05-normal-mapping/given/view.glsl"

#ifdef RECORDED_NORMALS
vec3 recorded_normal_of(Surface surface) { return recorded_normal(mat3(u_view), surface.normal_world); }
#endif

#ifdef NORMAL_MAP
uniform sampler2D u_normal_map;

// Of the surface before its position and texture coordinate were changed (06). xyz is zero where there is no frame.
vec4 surface_tangent = vec4(0.0);

#ifdef LIGHT_SPACE
// Lighting in tangent space, or in world space where there is no frame.
vec3 unmapped_normal = vec3(0.0);

vec3 to_light_space(vec3 v) {
  return surface_tangent.xyz == vec3(0.0) ? v : to_tangent_space(unmapped_normal, surface_tangent, v);
}
#endif

#ifdef FILTERED_EXPONENT
vec3 normal_texel = vec3(0.5, 0.5, 1.0);
float exponent_of(float exponent) { return filtered_exponent(exponent, normal_texel); }
#endif

#endif

void find_tangent(inout Surface surface) {
#ifdef NORMAL_MAP
  surface_tangent = tangent_at(surface);
#endif
}

void map_normal(inout Surface surface) {
#ifdef NORMAL_MAP
  vec3 texel = texture(u_normal_map, surface.texcoord).rgb, stored = decode_normal(texel);
#ifdef FILTERED_EXPONENT
  normal_texel = texel;
#endif
#ifdef LIGHT_SPACE
  unmapped_normal = surface.normal_world;
  surface.normal_light = surface_tangent.xyz == vec3(0.0) ? surface.normal_world : stored;
#endif
  surface.normal_world = mapped_normal(surface.normal_world, surface_tangent, stored);
#endif
}
