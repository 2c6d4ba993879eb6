// 03-shadow-mapping, the depth pass: the vertex shader that draws the scene into a shadow map.
//
// Given, declared already: mat4 u_model, u_light_view, u_light_projection.

// The position of a vertex in the clip space of the light. `position` is in object space. u_model takes it to world
// space; u_light_view and u_light_projection are the matrices that your C++ functions returned. The camera's u_view and
// u_projection have no value in this pass. Handout, section 2.
vec4 depth_pass_position(vec3 position) {
  // >>> student: from object space to the light's clip space
  return u_light_projection * (u_light_view * (u_model * vec4(position, 1.0)));
  // --- skeleton
  // | return vec4(0.0, 0.0, 0.0, 1.0);
  // <<< student
}
