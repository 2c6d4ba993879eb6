// 01-transforms, the vertex shader's part: how a corner of a mesh gets to its place. The matrices are those that your
// C++ functions made.

// The corner in clip space. OpenGL divides by w afterwards.
vec4 clip_position(mat4 projection, mat4 view, mat4 model, vec3 position) {
  return projection * (view * (model * vec4(position, 1.0)));
}

// The corner in world space.
vec3 world_position(mat4 model, vec3 position) {
  return (model * vec4(position, 1.0)).xyz;
}

// The normal in world space, of unit length. A model that is flattened leaves nothing of some normals, or of all:
// then the normal stays as it was.
vec3 world_normal(mat3 normal_matrix, vec3 normal) {
  vec3 turned = normal_matrix * normal;
  float length_squared = dot(turned, turned);
  return length_squared > 0.0 ? turned * inversesqrt(length_squared) : normal;
}
