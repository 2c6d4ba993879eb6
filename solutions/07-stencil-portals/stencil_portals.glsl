// 07-stencil-portals, for every pixel of a view that is seen through an opening. The contract of the function is the
// comment above it.

// Whether a point is not part of the view, because it lies before the exit: between the virtual camera and the plane of
// the opening. `plane` is (n, d); n.p + d is the distance of a point p from the plane in metres, at least 0 for what
// is seen. position and plane are in world space. Handout, section 3.
// plane = (0, 0, 1, -5): (1, 2, 4) is cut away, (1, 2, 5) and (1, 2, 6) are not.
bool cut_away(vec3 position, vec4 plane) {
  // >>> student: the sign of the distance
  return dot(plane, vec4(position, 1.0)) < 0.0;
  // --- skeleton
  // | return false;
  // <<< student
}
