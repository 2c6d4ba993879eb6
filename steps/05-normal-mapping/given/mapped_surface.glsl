// Applies a normal map to a surface point with the student's functions. Given.
#include "05-normal-mapping/normal_mapping.glsl"

#ifdef RECORDED_NORMALS
uniform mat4 u_view;

vec3 recorded_normal_of(Surface surface) { return recorded_normal(mat3(u_view), surface.normal_world); }
#endif

#ifdef NORMAL_MAP
uniform sampler2D u_normal_map;

// The tangent on the side of the surface that is seen. From behind, a bump is a dent: the mapped normal as a whole turns
// round, so all three axes do; as B = w cross(N, T), the sign w turns too.
vec4 tangent_at(Surface surface) {
#ifdef TWO_SIDED
  float side = gl_FrontFacing ? 1.0 : -1.0;
#else
  const float side = 1.0;
#endif
#ifdef DERIVATIVE_TANGENTS
  return side * derivative_tangent(side * surface.normal_world, dFdx(surface.position_world),
                                   dFdy(surface.position_world), dFdx(surface.texcoord), dFdy(surface.texcoord));
#else
  return side * surface.tangent_world;
#endif
}

#ifdef LIGHT_SPACE
// Lighting in tangent space: what to_light_space needs.
vec3 light_normal = vec3(0.0);
vec4 light_tangent = vec4(0.0);  // xyz is zero where there is no frame: then lighting stays in world space

vec3 to_light_space(vec3 v) {
  return light_tangent.xyz == vec3(0.0) ? v : to_tangent_space(light_normal, light_tangent, v);
}
#endif

#ifdef FILTERED_EXPONENT
vec3 normal_texel = vec3(0.5, 0.5, 1.0);
float exponent_of(float exponent) { return filtered_exponent(exponent, normal_texel); }
#endif

#endif

void map_normal(inout Surface surface) {
#ifdef NORMAL_MAP
  vec4 tangent = tangent_at(surface);
  vec3 texel = texture(u_normal_map, surface.texcoord).rgb, stored = decode_normal(texel);
#ifdef FILTERED_EXPONENT
  normal_texel = texel;
#endif
#ifdef LIGHT_SPACE
  light_normal = surface.normal_world;
  light_tangent = tangent;
  surface.normal_light = tangent.xyz == vec3(0.0) ? surface.normal_world : stored;
#endif
  surface.normal_world = mapped_normal(surface.normal_world, tangent, stored);
#endif
}
