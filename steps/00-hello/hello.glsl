// 00-hello: your first line of the course.
//
// The triangle has three corners. For every pixel inside it the program hands you three weights: how near the pixel is
// to the left corner, to the right corner and to the top corner. Each is 0 to 1, and together they are 1.

// The colour of a pixel as (red, green, blue), each 0 to 1.
vec3 hello_colour(vec3 weights) {
  // TODO(00-hello): let the left corner be red, the right one green and the top one blue
  return vec3(0.5);
}
