// Dithers the scene's light where its target has 8 bits. Given.
#include "08-post-processing/given/noise.glsl"

vec3 dithered_surface(Surface surface, vec3 shaded) { return kept(vec4(shaded, 1.0)).rgb; }
