// The view matrix, in the fragment shader. Given.
uniform mat4 u_view;
