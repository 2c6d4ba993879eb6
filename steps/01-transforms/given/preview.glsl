uniform vec3 u_colour;

// A checker pattern with 8 x 8 cells per texture, which makes texture coordinates visible.
float checker(vec2 texcoord) {
  vec2 cell = floor(texcoord * 8.0);
  return mod(cell.x + cell.y, 2.0) < 0.5 ? 1.0 : 0.72;
}

vec3 preview(Surface surface) {
  vec3 n = surface.normal_world, to_eye = surface.eye_world - surface.position_world;
  float facing = dot(n, n) > 0.0 && dot(to_eye, to_eye) > 0.0 ? dot(normalize(n), normalize(to_eye)) : 0.0;
  return u_colour * checker(surface.texcoord) * (0.15 + 0.85 * max(facing, 0.0));
}
