// preview_camera: eyes a millimetre to a kilometre away, paintings that are a thousandth to a hundredfold of that, and
// exits a million metres from the origin.
#include "stability/12-gallery/rows.hpp"

namespace atelier::stability {

using namespace gallery;

namespace {

/// What the camera sees of a point, in double precision: x and y from -1 to 1 in a picture of this ratio of width to
/// height, and the distance along the camera's axis.
glm::dvec3 seen(const Camera& camera, double ratio, const glm::dvec3& p) {
  const glm::dvec3 ahead = glm::normalize(camera.target - camera.eye);
  const glm::dvec3 right = glm::normalize(glm::cross(ahead, glm::dvec3(camera.up)));
  const glm::dvec3 from = p - camera.eye;
  const double depth = glm::dot(from, ahead), half = depth * std::tan(double(camera.fov_y) / 2);
  return {glm::dot(from, right) / (half * ratio), glm::dot(from, glm::cross(right, ahead)) / half, depth};
}

/// How far the corners of the exit's rectangle are from those of the picture.
double corner_error(const glm::dmat4& exit, const glm::dvec2& half_size, double distance) {
  const Camera camera = preview_camera(exit, half_size, distance, float(2 * distance));
  double worst = 0;
  for (int i = 0; i < 4; ++i) {
    const double x = i & 1 ? 1 : -1, y = i & 2 ? 1 : -1;
    const glm::dvec3 corner(at(exit, {x * half_size.x, y * half_size.y, 0}));
    // Whoever looks along the exit's +z has its +x on the left.
    const glm::dvec3 place = seen(camera, half_size.x / half_size.y, corner);
    const double here = std::max(std::abs(place.x + x), std::abs(place.y - y));
    worst = std::isnan(here) ? double(infinite) : std::max(worst, here);
  }
  return worst;
}

/// What one rounding of fov_y may cost at the edge of a picture, where its half angle has this tangent: the angle's
/// error, half of it, by the derivative of the tangent, as a share of the tangent.
double cost_of_angle(double tangent) {
  const double angle = 2 * std::atan(tangent);
  return rounding_unit * angle / 2 * (1 + tangent * tangent) / tangent;
}

void add_near_rows(Group& group) {
  for (const double distance : {1e-3, 1.0, 1e3})
    for (const double tangent : {1e-3, 0.1, 1.0, 10.0, 100.0}) {
      const std::string words =
          fmt::format("an eye {:g} m away, half a height of {:g} m", distance, distance * tangent);
      // The eye and the corners have roundings of their distance from the origin.
      const double places =
          metres(10 + distance + distance * tangent, "").value / std::min(distance, 0.1 * distance * tangent);
      group.close(words + ", 200 frames: corners of the exit at those of the picture",
                  {2 * cost_of_angle(tangent) + places, "of half the picture",
                   "two roundings of fov_y, times how steep its tangent is there; and roundings of places 10 m away"},
                  [=] {
                    return worst_of(200, 2090, [=](Trial& t) {
                      const double height = distance * tangent, width = height * t.size_between(0.1, 10);
                      return corner_error(upright_frame(t, 10), {width, height}, distance);
                    });
                  });
    }
  for (const double distance : {1e-3, 1.0, 1e3})
    group.close(fmt::format("an eye {:g} m away, 200 frames: the near plane is the exit's", distance),
                {2 * rounding_unit, "relative", "a distance, rounded to a float"}, [=] {
                  return worst_of(200, 2091, [=](Trial& t) {
                    const glm::dmat4 exit = upright_frame(t, 10);
                    const Camera camera = preview_camera(exit, {1, 1}, distance, float(2 * distance));
                    return std::abs(seen(camera, 1, glm::dvec3(exit[3])).z / double(camera.near) - 1);
                  });
                });
}

}  // namespace

void add_camera_rows(Table& table) {
  Group group = table.of("preview_camera");
  add_near_rows(group);
  for (const double place : {1.0, 1e3, million})
    for (const double distance : {1e-3, 3.0, 1e3}) {
      const std::string words = fmt::format("exits {:g} m from the origin, an eye {:g} m away", place, distance);
      group.close(
          words + ", 1000 frames: the eye's place", metres(place + distance, "a product and a sum of that size"), [=] {
            return worst_of(1000, 2092, [=](Trial& t) {
              const glm::dmat4 exit = upright_frame(t, place);
              return largest_of(Exact(preview_camera(exit, {1, 1}, distance, 1e4f).eye) - at(exit, {0, 0, -distance}));
            });
          });
      group.close(words + ", 1000 frames: where it looks",
                  {16 * double_unit * (place + distance) / distance * 180 / std::numbers::pi, "degrees",
                   "eye and target are rounded at that size, and that near to each other"},
                  [=] {
                    return worst_of(1000, 2093, [=](Trial& t) {
                      const glm::dmat4 exit = upright_frame(t, place);
                      const Camera camera = preview_camera(exit, {1, 1}, distance, 1e4f);
                      return degrees_between(camera.target - camera.eye, glm::dvec3(exit[2]));
                    });
                  });
    }
  group.close("half heights of 1e-3 to 100 distances: fov_y", {2 * rounding_unit, "relative", "a float, rounded"}, [] {
    return worst_of(1000, 2094, [](Trial& t) {
      const double distance = t.size_between(1e-3, 1e3), tangent = t.size_between(1e-3, 100);
      const Camera camera = preview_camera(glm::dmat4(1), {1, distance * tangent}, distance, 1e7f);
      return std::abs(double(camera.fov_y) / (2 * std::atan(tangent)) - 1);
    });
  });
  group.equals("the width does not matter to fov_y; far, up and the kind of projection",
               [] {
                 const Camera narrow = preview_camera(glm::dmat4(1), {1e-3, 1}, 2, 1e30f),
                              wide = preview_camera(glm::dmat4(1), {1e3, 1}, 2, 1e30f);
                 return Values{double(narrow.fov_y == wide.fov_y),
                               double(wide.far),
                               double(wide.up.x),
                               double(wide.up.y),
                               double(wide.up.z),
                               double(wide.projection == Projection::perspective)};
               },
               {1, double(1e30f), 0, 1, 0, 1});
}

}  // namespace atelier::stability
