// face_view, face_projection: what is drawn must lie where the card looks it up, at every edge and far from the origin.
#include <climits>

#include "stability/04-point-shadows/rows.hpp"

namespace atelier::stability {

using point_shadows::face_projection;
using point_shadows::face_view;

namespace {

/// Where OpenGL looks a direction up: the face and (s, t) from -1 to 1 there (specification 3.3, section 3.8.10).
struct Place {
  int face;
  glm::dvec2 st;
};
Place looked_up(const glm::dvec3& d) {
  const glm::dvec3 a = glm::abs(d);
  if (a.x >= a.y && a.x >= a.z)
    return d.x > 0 ? Place{0, glm::dvec2(-d.z, -d.y) / a.x} : Place{1, glm::dvec2(d.z, -d.y) / a.x};
  if (a.y >= a.z) return d.y > 0 ? Place{2, glm::dvec2(d.x, d.z) / a.y} : Place{3, glm::dvec2(d.x, -d.z) / a.y};
  return d.z > 0 ? Place{4, glm::dvec2(d.x, -d.y) / a.z} : Place{5, glm::dvec2(-d.x, -d.y) / a.z};
}

/// How far from there the face's matrices draw a point in this direction, in half faces.
double misplaced(const glm::vec3& lamp, const glm::dvec3& direction, float near, float far) {
  const Place place = looked_up(direction);
  const glm::mat4 matrix = face_projection(near, far) * face_view(lamp, place.face);
  const glm::dvec4 clip = glm::dmat4(matrix) * glm::dvec4(glm::dvec3(lamp) + direction, 1);
  return difference(values(glm::dvec2(clip) / clip.w), values(place.st));
}

}  // namespace

void add_face_rows(Table& table) {
  Group view = table.of("face_view");
  for (const int face : {-1, 6, INT_MAX, INT_MIN})
    view.refuses(fmt::format("face {}", face), [face] { face_view({0, 0, 0}, face); });
  view.equals(
      "six views at the origin: whole numbers",
      [] {
        Values fractions;
        for (int face = 0; face < 6; ++face)
          for (const double x : values(face_view({0, 0, 0}, face))) fractions.push_back(x - std::round(x));
        return fractions;
      },
      Values(96, 0));
  for (const float offset : {1e3f, 1e6f, 8e6f})
    view.equals(
        fmt::format("a lamp at ({0:g}, -{0:g}, {0:g}): the same six turns", offset),
        [offset] {
          Values parted;
          for (int face = 0; face < 6; ++face)
            parted.push_back(difference(values(glm::mat3(face_view({offset, -offset, offset}, face))),
                                        values(glm::mat3(face_view({0, 0, 0}, face)))));
          return parted;
        },
        Values(6, 0));
  view.close("a lamp 1000 m away at 300 random places: it is its own origin",
             {4 * rounding_unit * 1000 * 1.7320508, "metres", "three products of an axis and the position, summed"},
             [] {
               return worst_of(300, 400, [](Trial& t) {
                 const glm::vec3 lamp(t.in_cube(1000));
                 const glm::dmat4 seen(face_view(lamp, int(t.between(0, 6))));
                 return glm::length(glm::dvec3(seen * glm::dvec4(lamp, 1)));
               });
             });

  Group both = table.of("face_projection x face_view");
  const Bound in_place{6 * rounding_unit, "half faces",
                       "the tangent of 45 degrees is a rounding off, and so is its use"};
  both.close("3000 random directions: drawn where they are looked up", in_place, [] {
    return worst_of(3000, 401, [](Trial& t) { return misplaced({0, 0, 0}, t.direction(), 0.01f, 10); });
  });
  both.close("on edges and corners and 1e-6 beside them", in_place, [] {
    double worst = 0;
    for (const glm::vec3& direction : directions_near_edges(1e-6f))
      worst = std::max(worst, misplaced({0, 0, 0}, direction, 0.01f, 10));
    return worst;
  });
  both.close("near 1e-3, far 1e6: nothing moves aside", in_place, [] {
    return worst_of(300, 402, [](Trial& t) {
      return misplaced({0, 0, 0}, t.size_between(1e-2, 1e5) * t.direction(), 1e-3f, 1e6f);
    });
  });

  Group projection = table.of("face_projection");
  projection.close("as wide as high, and 90 degrees: six leave no gap",
                   {2 * rounding_unit, "relative", "a float's quarter turn is off by 4e-8"}, [] {
                     const glm::mat4 p = face_projection(1e-3f, 1e6f);
                     return difference({p[0][0], p[1][1]}, {1, 1});
                   });
  projection.refuses("near 0", [] { face_projection(0, 1); });
  projection.refuses("far before near", [] { face_projection(2, 1); });
}

}  // namespace atelier::stability
