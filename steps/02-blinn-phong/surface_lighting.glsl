// Gathers the material of a surface point and hands it to the student's `shade`. Given.
#include "02-blinn-phong/blinn_phong.glsl"

uniform vec3 u_diffuse, u_specular;
uniform float u_exponent;
#ifdef EMISSION
uniform vec3 u_emission;
#else
const vec3 u_emission = vec3(0.0);
#endif
#ifdef DIFFUSE_MAP
uniform sampler2D u_diffuse_map;
#endif
#ifdef SPECULAR_MAP
uniform sampler2D u_specular_map;
#endif

vec3 texel_colour(sampler2D map, vec2 texcoord) {
#ifdef DECODE_AFTER_FILTER
  return srgb_decode(texture(map, texcoord).rgb);
#else
  return texture(map, texcoord).rgb;
#endif
}

Material material_at(Surface surface) {
  Material m = Material(u_diffuse, u_specular, u_exponent);
#ifdef DIFFUSE_MAP
  m.diffuse *= texel_colour(u_diffuse_map, surface.texcoord);
#endif
#ifdef SPECULAR_MAP
  m.specular *= texel_colour(u_specular_map, surface.texcoord);
#endif
  return m;
}

vec3 shade_material(Surface surface, Material m) {
  return shade(surface.position_world, surface.normal_world, surface.eye_world, m);
}

vec3 shade_surface(Surface surface) { return u_emission + shade_material(surface, material_at(surface)); }

// Intermediates: one part of the model alone.

vec3 shade_diffuse_only(Surface surface) {
  Material m = material_at(surface);
  m.specular = vec3(0.0);
  return shade_material(surface, m);
}

vec3 shade_specular_only(Surface surface) {
  Material m = material_at(surface);
  m.diffuse = vec3(0.0);
  return shade_material(surface, m);
}
