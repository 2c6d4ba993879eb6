// How bright a display shows light, in about even steps for the eye: 0..1 a channel. Its codes are those of sRGB up to
// 0.04, and a root is cheaper than sRGB's power. Given.
#ifndef SHOWN
#define SHOWN
vec3 shown(vec3 light) { return sqrt(clamp(light, 0.0, 1.0)); }
#endif
