// 03-shadow-mapping, the depth pass: where a corner of a mesh stands in the shadow map. What the function must do, and
// which uniforms it has, stands in shadow_mapping.hpp.

vec4 depth_pass_position(vec3 position) {
  return u_light_projection * (u_light_view * (u_model * vec4(position, 1.0)));
}
