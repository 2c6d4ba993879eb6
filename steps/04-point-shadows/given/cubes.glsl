// Types, uniforms and functions of step 04's shaders. Given. World space, metres.
#include "03-shadow-mapping/given/shadows.glsl"

struct CubeLight {
  vec3 position;
  float far;  // the distance that is stored as 1
  int cube;   // the index of its cube map: the first argument of the functions below
};

// All point lights that have a cube map, at most 4.
#if CUBES > 0
uniform CubeLight u_cube_lights[CUBES];
#endif

// GLSL 3.30 cannot choose a sampler by a variable, and OpenGL 3.3 has no cube map arrays: so each has its own name.
#ifdef COMPARE
#define CUBE_SAMPLER samplerCubeShadow
#else
#define CUBE_SAMPLER samplerCube
#endif
#if CUBES > 0
uniform CUBE_SAMPLER u_cube_0;
#endif
#if CUBES > 1
uniform CUBE_SAMPLER u_cube_1;
#endif
#if CUBES > 2
uniform CUBE_SAMPLER u_cube_2;
#endif
#if CUBES > 3
uniform CUBE_SAMPLER u_cube_3;
#endif

// Texels along an edge of a cube map.
float cube_resolution() {
#if CUBES > 0
  return float(textureSize(u_cube_0, 0).x);
#else
  return 1.0;
#endif
}

// With COMPARE: compares the reference with the four nearest texels in this direction and interpolates the results; 1
// means that the reference is at most the stored value. Without: returns the stored value.
#ifdef COMPARE
float compared_with_cube(int cube, vec3 direction, float reference) {
#define ANSWER(sampler) texture(sampler, vec4(direction, reference))
#else
float stored_in_cube(int cube, vec3 direction) {
#define ANSWER(sampler) texture(sampler, direction).r
#endif
#if CUBES > 3
  if (cube == 3) return ANSWER(u_cube_3);
#endif
#if CUBES > 2
  if (cube == 2) return ANSWER(u_cube_2);
#endif
#if CUBES > 1
  if (cube == 1) return ANSWER(u_cube_1);
#endif
#if CUBES > 0
  return ANSWER(u_cube_0);
#else
  return 1.0;
#endif
}
