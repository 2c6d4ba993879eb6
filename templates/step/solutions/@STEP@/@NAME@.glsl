// What reaches the eye of `light` after `way` metres through air of this colour and density, 1/m: the share
// exp(-density way) of the light, and of the air's colour the rest. With pieces > 0 an approximation: the way is cut
// into as many equal pieces, and each lets the share max(1 - density way / pieces, 0) through. The way is 0 to 1e30 m,
// the density 0 or more: a density of 0 leaves the light as it is.
vec3 @NAME@_light(vec3 light, vec3 air, float density, float way, int pieces) {
  // >>> student: what the air lets through of the light, and what it adds
  float through = exp(-density * way);
  if (pieces > 0) through = pow(max(1.0 - density * way / float(pieces), 0.0), float(pieces));
  return mix(air, light, through);
  // --- skeleton
  // | return light;
  // <<< student
}
