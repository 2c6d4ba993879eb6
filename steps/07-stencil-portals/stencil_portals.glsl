// 07-stencil-portals, for every pixel: what a view through an opening loses, and which light comes through one. The
// contract of each function is the comment above it.

// Whether a point is not part of the view, because it lies before the exit: between the virtual camera and the plane of
// the opening. `plane` is (n, d); n.p + d is the distance of a point p from the plane in metres, at least 0 for what
// is seen. position and plane are in world space. Handout, section 3.
// plane = (0, 0, 1, -5): (1, 2, 4) is cut away, (1, 2, 5) and (1, 2, 6) are not.
bool cut_away(vec3 position, vec4 plane) {
  // TODO(07-stencil-portals): the sign of the distance
  return false;
}

// (challenge) Whether the light of an image reaches a point through the opening. world_to_exit maps world space to the
// exit's frame. The image is behind the exit, at z < 0. Its light comes out of the rectangle |x| <= half_size.x, |y| <=
// half_size.y of the plane z = 0, and goes on to z > 0. position is the point, to_light the direction to the image, of
// unit length; both in world space. False for a point behind the exit or on its plane. At the rectangle's rim either
// answer is right. Handout, section 8.
// Exit at the origin, not turned, half_size (1, 1): from (0, 0, 2) towards (0, 0, -1) it does; from (0, 0, 2) towards
// (0.8, 0, -0.6) it does not, since that line meets the plane at (2.67, 0, 0).
bool comes_out(vec3 position, vec3 to_light, mat4 world_to_exit, vec2 half_size) {
  // TODO(07-stencil-portals): in the exit's frame: where does the line to the image meet the plane?
  return false;
}
