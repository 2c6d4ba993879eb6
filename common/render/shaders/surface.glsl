// A surface point in the fragment shader. Features change it slot by slot before it is shaded.
struct Surface {
  vec3 position_world;  // metres
  vec3 normal_world;    // interpolated between the vertices, so in general NOT of unit length; flipped to the viewer's side on two-sided materials
  vec2 texcoord;        // (0,0) lower left
  vec3 eye_world;       // position of the eye
#ifdef TANGENTS
  vec4 tangent_world;  // along +u, interpolated between unit vectors; w is the sign of the bitangent; xyz is 0 if there is none. Of the front side
#endif
#ifdef FRAGMENT_DEPTH
  float depth;  // as it is stored, 0..1
#endif
#ifdef LIGHT_SPACE
  vec3 normal_light;  // the normal in the space in which light is computed
#endif
};
