// Lets the images of lights shine through their openings alone. Given.
#include "02-blinn-phong/given/lights.glsl"
#include "07-stencil-portals/stencil_portals.glsl"

struct LightImage {
  mat4 world_to_exit;  // the frame of the opening that the light comes out of
  vec2 half_size;      // of the opening, metres
};
uniform LightImage u_light_images[LIGHT_IMAGES];

// The index of each light in u_light_images; -1: it is a light of the scene.
#if POINT_LIGHTS > 0
const int point_images[POINT_LIGHTS] = int[](POINT_IMAGES);
#endif
#if SPOT_LIGHTS > 0
const int spot_images[SPOT_LIGHTS] = int[](SPOT_IMAGES);
#endif
#if DIRECTIONAL_LIGHTS > 0
const int directional_images[DIRECTIONAL_LIGHTS] = int[](DIRECTIONAL_IMAGES);
#endif

float through_opening_of(int image, vec3 position, vec3 to_light) {
  if (image < 0) return 1.0;
  return comes_out(position, to_light, u_light_images[image].world_to_exit, u_light_images[image].half_size) ? 1.0
                                                                                                             : 0.0;
}

float point_light_through_opening(int light, vec3 position, vec3 normal, vec3 to_light) {
#if POINT_LIGHTS > 0
  return through_opening_of(point_images[light], position, to_light);
#else
  return 1.0;
#endif
}

float spot_light_through_opening(int light, vec3 position, vec3 normal, vec3 to_light) {
#if SPOT_LIGHTS > 0
  return through_opening_of(spot_images[light], position, to_light);
#else
  return 1.0;
#endif
}

float directional_light_through_opening(int light, vec3 position, vec3 normal, vec3 to_light) {
#if DIRECTIONAL_LIGHTS > 0
  return through_opening_of(directional_images[light], position, to_light);
#else
  return 1.0;
#endif
}
