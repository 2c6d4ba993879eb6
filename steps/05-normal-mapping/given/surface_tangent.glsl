// The tangent of a pixel with the student's functions, by the setting normal.tangents. Given.
#include "05-normal-mapping/normal_mapping.glsl"

#if defined(TANGENTS) || defined(DERIVATIVE_TANGENTS)
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
#endif
