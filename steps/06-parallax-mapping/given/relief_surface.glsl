// Finds the point of the relief for a pixel with the student's functions. Given.
#include "05-normal-mapping/given/surface_tangent.glsl"
#include "05-normal-mapping/given/view.glsl"
#include "06-parallax-mapping/parallax_mapping.glsl"

#ifdef RECORDED_HEIGHTS
uniform vec2 u_recorded;  // metres: nearest, farthest
float recorded_height_of(Surface surface) {
  return recorded_height((u_view * vec4(surface.position_world, 1.0)).xyz, u_recorded.x, u_recorded.y);
}
#endif

#ifdef RELIEF
// Of the relief, as a fraction of the texture's side.
uniform float u_depth;
uniform int u_layers;
// The lowest and the highest texture coordinate of the surface.
uniform vec4 u_edges;
#ifdef FRAGMENT_DEPTH
uniform mat4 u_projection;
#endif

// Of the surface, before it was changed: what self-shadows need.
vec3 relief_normal = vec3(0.0);
vec4 relief_tangent = vec4(0.0);
vec2 relief_texcoord = vec2(0.0);
float relief_height = 1.0;
bool outside_relief = false;

#ifdef SILHOUETTE
// How much the surface turns on the way of the ray along it: its normal curvature, 1/m, positive where it is convex.
// The way is x pixels to the right and y up, up to a factor, by Cramer's rule with cross products: they keep their
// digits where the surface is seen from its edge. 0 where neighbouring pixels show one point. Takes derivatives: call
// it before any return that only some pixels take.
float curvature_along(vec3 way, vec3 normal, vec3 position) {
  vec3 right = dFdx(position), up = dFdy(position), area = cross(right, up);
  float x = dot(cross(way, up), area), y = dot(cross(right, way), area);
  vec3 along = x * right + y * up, turn = x * dFdx(normal) + y * dFdy(normal);
  float square = dot(along, along);
  return square > 0.0 ? dot(turn, along) / square : 0.0;
}
#endif

// t of the ray's point on the relief; below 0 where it misses it.
float relief_hit(vec2 texcoord, vec2 span, float bend) {
#if METHOD == 1
  return offset_hit(texcoord);
#else
  int layers = u_layers;
#ifdef ADAPTIVE
#ifdef SILHOUETTE
  layers = layers_needed(ray_end(bend) * span, texcoord_dx, texcoord_dy, layers);
#else
  layers = layers_needed(span, texcoord_dx, texcoord_dy, layers);
#endif
#endif
#ifdef SILHOUETTE
  return curved_hit(texcoord, span, bend, layers);
#else
  vec2 interval = first_step_below(texcoord, span, layers);
#if METHOD == 2
  return interval.y;
#elif METHOD == 3
#ifdef MEAN
  return 0.5 * (interval.x + interval.y);
#else
  return secant_hit(texcoord, span, interval);
#endif
#else
  return interval.y > 0.0 ? bisected_hit(texcoord, span, interval, BISECTIONS) : 0.0;
#endif
#endif
#endif
}

// Metres of the surface for one unit of u.
float metres_a_texture(vec3 position) {
  float determinant = texcoord_dx.x * texcoord_dy.y - texcoord_dx.y * texcoord_dy.x;
  vec3 along_u = (dFdx(position) * texcoord_dy.y - dFdy(position) * texcoord_dx.y) / determinant;
  return determinant != 0.0 ? length(along_u) : 0.0;
}
#endif

void find_relief(inout Surface surface) {
#ifdef RELIEF
  texcoord_dx = dFdx(surface.texcoord);
  texcoord_dy = dFdy(surface.texcoord);
  float side = metres_a_texture(surface.position_world), bend = 0.0;
  relief_normal = surface.normal_world;
  relief_tangent = tangent_at(surface);
  relief_texcoord = surface.texcoord;
#ifdef SILHOUETTE
  vec3 normal = normalize(surface.normal_world), way = surface.position_world - surface.eye_world;
  way -= dot(way, normal) * normal;
  float curvature = curvature_along(way, normal, surface.position_world);
#endif
  if (relief_tangent.xyz == vec3(0.0)) return;  // no frame: the surface stays flat
  vec3 to_eye = normalize(to_tangent_space(relief_normal, relief_tangent, surface.eye_world - surface.position_world));
  vec2 span = parallax_span(to_eye, u_depth);
#ifdef SILHOUETTE
  bend = ray_bend(span, u_depth, side, curvature);
#endif
  float t = relief_hit(surface.texcoord, span, bend);
#ifdef SILHOUETTE
  outside_relief = t < 0.0;
  if (outside_relief) return;
#endif
  surface.texcoord += t * span;
  relief_texcoord = surface.texcoord;
  relief_height = 1.0 - t + bend * t * t;
  surface.position_world = relief_position(surface.position_world, surface.eye_world, to_eye, u_depth * side, t);
#ifdef DISCARD_EDGES
  outside_relief = beyond_edges(surface.texcoord, u_edges.xy, u_edges.zw);
#endif
#ifdef FRAGMENT_DEPTH
  surface.depth = depth_of(u_projection * u_view, surface.position_world);
#endif
#endif
}

bool discard_outside_relief(Surface surface) {
#if defined(DISCARD_EDGES) || defined(SILHOUETTE)
  return outside_relief;
#else
  return false;
#endif
}

float light_on_relief(int light, vec3 position, vec3 normal, vec3 to_light) {
#ifdef SHADOW_SAMPLES
  if (relief_tangent.xyz == vec3(0.0)) return 1.0;
  vec3 l = to_tangent_space(relief_normal, relief_tangent, to_light);
  if (l.z <= 0.0) return 0.0;  // the light is below the surface
  return relief_visibility(relief_texcoord, relief_height, l.xy / max(l.z, 0.05) * u_depth, SHADOW_SAMPLES);
#else
  return 1.0;
#endif
}
