// Collects the material of a surface point and passes it to the student's `shade`. Given.
#include "02-blinn-phong/blinn_phong.glsl"

uniform vec3 u_diffuse;
uniform vec3 u_specular;
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

#ifdef FILTERED_EXPONENT
float exponent_of(float exponent);  // by a later step: of a highlight on filtered normals
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
#ifdef FILTERED_EXPONENT
  m.exponent = exponent_of(m.exponent);
#endif
  return m;
}

#ifdef VISIBILITY
vec3 unit_way(vec3 from, vec3 to) {
  vec3 difference = to - from;
  float distance = length(difference);
  return distance > 0.0 ? difference / distance : vec3(0.0, 1.0, 0.0);
}

// For every light, at every pixel: the functions called here may use derivatives, which need neighbouring pixels.
void find_visibility(vec3 position, vec3 normal) {
  vec3 n = dot(normal, normal) > 0.0 ? normalize(normal) : vec3(0.0);
#if POINT_LIGHTS > 0
  for (int i = 0; i < POINT_LIGHTS; ++i)
    point_visibility[i] =
        point_light_is_here(i)
            ? visibility_of_point_light(i, position, n, unit_way(position, u_point_lights[i].position))
            : 0.0;
#endif
#if SPOT_LIGHTS > 0
  for (int i = 0; i < SPOT_LIGHTS; ++i)
    spot_visibility[i] =
        spot_light_is_here(i)
            ? visibility_of_spot_light(i, position, n, unit_way(position, u_spot_lights[i].position))
            : 0.0;
#endif
#if DIRECTIONAL_LIGHTS > 0
  for (int i = 0; i < DIRECTIONAL_LIGHTS; ++i)
    directional_visibility[i] =
        directional_light_is_here(i)
            ? visibility_of_directional_light(i, position, n, -u_directional_lights[i].direction)
            : 0.0;
#endif
}
#endif

#ifdef LIGHT_SPACE
vec3 to_light_space(vec3 v);  // by a later step: a rotation

// The lights in world space, or in light space with `origin` as their origin.
void place_lights(bool there, vec3 origin) {
#if POINT_LIGHTS > 0
  for (int i = 0; i < POINT_LIGHTS; ++i) {
    u_point_lights[i] = point_light_in_world(i);
    if (there) u_point_lights[i].position = to_light_space(u_point_lights[i].position - origin);
  }
#endif
#if SPOT_LIGHTS > 0
  for (int i = 0; i < SPOT_LIGHTS; ++i) {
    u_spot_lights[i] = spot_light_in_world(i);
    if (!there) continue;
    u_spot_lights[i].position = to_light_space(u_spot_lights[i].position - origin);
    u_spot_lights[i].direction = to_light_space(u_spot_lights[i].direction);
  }
#endif
#if DIRECTIONAL_LIGHTS > 0
  for (int i = 0; i < DIRECTIONAL_LIGHTS; ++i) {
    u_directional_lights[i] = directional_light_in_world(i);
    if (there) u_directional_lights[i].direction = to_light_space(u_directional_lights[i].direction);
  }
#endif
}
#endif

vec3 shade_material(Surface surface, Material m) {
#ifdef VISIBILITY
#ifdef LIGHT_SPACE
  place_lights(false, vec3(0.0));  // visibility is a matter of world space
#endif
  find_visibility(surface.position_world, surface.normal_world);
#endif
#ifdef LIGHT_SPACE
  place_lights(true, surface.position_world);
  return shade(vec3(0.0), surface.normal_light, to_light_space(surface.eye_world - surface.position_world), m);
#else
  return shade(surface.position_world, surface.normal_world, surface.eye_world, m);
#endif
}

vec3 shade_surface(Surface surface) { return u_emission + shade_material(surface, material_at(surface)); }

// Intermediate results: only one term of the model.

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
