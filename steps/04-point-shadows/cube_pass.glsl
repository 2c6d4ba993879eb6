// 04-point-shadows, the cube pass: how triangles get into the six faces, and what is stored there. The contract of a
// function is the comment above it. GEOMETRY is defined for the geometry shader, FRAGMENT for the fragment shader.
//
// Given to the geometry shader, declared already: triangles go in, a triangle strip of at most 18 vertices comes out;
//   in vec3 v_corner_world[3];        uniform mat4 u_face_matrices[6];
//   out vec3 g_position_world;        uniform float u_face_wanted[6];

#ifdef GEOMETRY
// Draws one triangle into every face whose u_face_wanted[face] is above 0.5, each time as a separate triangle. Its
// corners are v_corner_world[0] to v_corner_world[2], in world space. Each vertex has three outputs:
// - gl_Layer: the face, 0 to 5;
// - gl_Position: the corner in the clip space of this face; u_face_matrices[face] takes world space there;
// - g_position_world: the corner in world space, for the fragment shader.
// Inputs, outputs and uniforms are declared already. Handout, section 3.
void draw_in_faces() {
  // TODO(04-point-shadows): one triangle for each face that is wanted
}
#endif

#ifdef FRAGMENT
// What a texel stores: the distance between the two points as a fraction of far, at most 1. World space, metres.
// (3, 4, 0) from a light at the origin with far = 10: 0.5. Handout, section 4.
float stored_distance(vec3 position, vec3 light, float far) {
  // TODO(04-point-shadows): the distance as a fraction of far
  return 1.0;
}
#endif
