// 01-transforms, the vertex shader's part: how a corner of a mesh gets to its place. The matrices are those that your
// C++ functions made.

// The corner in clip space. OpenGL divides by w afterwards.
vec4 clip_position(mat4 projection, mat4 view, mat4 model, vec3 position) {
  // TODO(01-transforms): object to world to view to clip; a position has w = 1
  return vec4(position, 1.0);
}

// The corner in world space.
vec3 world_position(mat4 model, vec3 position) {
  // TODO(01-transforms): a position has w = 1
  return position;
}

// The normal in world space, of unit length. A model that is flattened leaves nothing of some normals, or of all:
// then the normal stays as it was.
vec3 world_normal(mat3 normal_matrix, vec3 normal) {
  // TODO(01-transforms): multiply, test for zero length, normalise
  return normal;
}
