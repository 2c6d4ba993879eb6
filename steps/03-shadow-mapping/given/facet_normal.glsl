// The normal that a bias gets. Given.

// The unit normal of the facet, on the side of the interpolated `normal`; zero where that is zero. The map holds facets:
// where an interpolated normal faces the light, its facet may still be inclined, and a bias by the interpolated normal
// is too small. From the derivatives of the position; where these have less than two digits left, because the point is
// near the eye and far from the origin of the world, it is the interpolated normal.
vec3 facet_normal(vec3 position, vec3 normal) {
  vec3 dx = dFdx(position), dy = dFdy(position), size = abs(position);
  float rounding = 1.2e-7 * max(size.x, max(size.y, size.z));
  if (min(length(dx), length(dy)) <= 100.0 * rounding) return normal;
  vec3 facet = cross(normalize(dx), normalize(dy));
  float side = dot(facet, normal), length_squared = dot(facet, facet);
  return side != 0.0 && length_squared > 1e-12 ? facet * sign(side) * inversesqrt(length_squared) : normal;
}
