// 03-shadow-mapping, the depth pass: where a corner of a mesh stands in the shadow map. What the function must do, and
// which uniforms it has, stands in shadow_mapping.hpp.

vec4 depth_pass_position(vec3 position) {
  // TODO(03-shadow-mapping): object to world to the light's space to clip space; the camera has no part in it
  return vec4(0.0, 0.0, 0.0, 1.0);
}
