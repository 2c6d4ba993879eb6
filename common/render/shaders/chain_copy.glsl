// A pass that changes nothing.
vec4 copied(vec2 texcoord) { return texture(u_picture, texcoord); }
