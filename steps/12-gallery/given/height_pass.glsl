// The height map of a room's picture, through the lens of its style. Given.
#include "10-artstyles/given/style_passes.glsl"

vec4 height_pass(vec2 texcoord) {
  vec2 source;
  if (!map_source(texcoord, source)) return vec4(0.0, 0.0, 0.0, 1.0);
  return vec4(texture(u_recorded_height, source).rgb, 1.0);
}
