// 04-point-shadows, the cube pass: one triangle into six faces, and what is stored there. What each function must do stands
// in point_shadows.hpp. GEOMETRY is defined for the geometry shader, FRAGMENT for the fragment shader.

#ifdef GEOMETRY
void draw_in_faces() {
  for (int face = 0; face < 6; ++face) {
    if (u_face_wanted[face] <= 0.5) continue;
    for (int corner = 0; corner < 3; ++corner) {
      gl_Layer = face;
      gl_Position = u_face_matrices[face] * vec4(v_corner_world[corner], 1.0);
      g_position_world = v_corner_world[corner];
      EmitVertex();
    }
    EndPrimitive();
  }
}
#endif

#ifdef FRAGMENT
float stored_distance(vec3 position, vec3 light, float far) {
  return min(length(position - light) / far, 1.0);
}
#endif
