// A point of a surface as the fragment shader sees it. Features change it slot by slot before it is shaded.
struct Surface {
  vec3 position_world;  // metres
  vec3 normal_world;    // interpolated between the corners, so in general NOT of unit length; turned to the viewer on two-sided materials
  vec2 texcoord;        // (0,0) lower left
  vec3 eye_world;       // where the viewer stands
#ifdef TANGENTS
  vec4 tangent_world;  // along +u, interpolated and not made unit; w is the sign of the bitangent; xyz is 0 where there is none
#endif
};
