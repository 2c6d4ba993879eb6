// 04-point-shadows, the cube pass: one triangle into six faces, and what is stored there. What each function must do stands
// in point_shadows.hpp. GEOMETRY is defined for the geometry shader, FRAGMENT for the fragment shader.

#ifdef GEOMETRY
void draw_in_faces() {
  // TODO(04-point-shadows): for each face that is wanted, three corners with gl_Layer, gl_Position and g_position_world
}
#endif

#ifdef FRAGMENT
float stored_distance(vec3 position, vec3 light, float far) {
  // TODO(04-point-shadows): the distance as a share of the farthest
  return 1.0;
}
#endif
