// Clips views by discarding fragments. Given.
#include "07-stencil-portals/stencil_portals.glsl"

uniform vec4 u_opening_plane;

bool discard_before_exit(Surface surface) {
  return cut_away(surface.position_world, u_opening_plane);
}
