// The colour that reaches the eye after `way` metres of fog with the colour `air` and this density, 1/m: the fraction
// f = exp(-density way) of `light`, plus the fraction 1 - f of `air`. With pieces > 0 an approximation: the way is
// divided into this many equal pieces, and each lets the fraction max(1 - density way / pieces, 0) through. The way is
// 0 to 1e30 m, the density 0 or more: a density of 0 leaves the light unchanged.
vec3 @NAME@_light(vec3 light, vec3 air, float density, float way, int pieces) {
  // >>> student: the light that passes the fog, and the light that the fog adds
  float through = exp(-density * way);
  if (pieces > 0) through = pow(max(1.0 - density * way / float(pieces), 0.0), float(pieces));
  return mix(air, light, through);
  // --- skeleton
  // | return light;
  // <<< student
}
