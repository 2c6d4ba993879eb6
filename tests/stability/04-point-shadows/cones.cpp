// cone_around: no spheres, a lamp within one, all round, and at every size.
#include "stability/04-point-shadows/rows.hpp"

namespace atelier::stability {

using point_shadows::Cone;
using point_shadows::cone_around;
using point_shadows::Sphere;

namespace {

constexpr float any_width = 4;

/// 1 and the cone, or 0 alone.
Values found(const glm::vec3& position, const std::vector<Sphere>& spheres, float widest = any_width) {
  const std::optional<Cone> cone = cone_around(position, spheres, widest);
  if (!cone) return {0};
  return {1, cone->axis.x, cone->axis.y, cone->axis.z, cone->half_angle};
}

/// The angle from the axis to a sphere's farthest edge, in double precision.
double reach(const glm::dvec3& axis, const glm::vec3& position, const Sphere& sphere) {
  const glm::dvec3 way = glm::dvec3(sphere.centre) - glm::dvec3(position);
  return std::atan2(glm::length(glm::cross(axis, way)), glm::dot(axis, way)) +
         std::asin(double(sphere.radius) / glm::length(way));
}

/// How far the half-angle is from the widest reach of spheres.
double half_angle_error(const glm::vec3& position, const std::vector<Sphere>& spheres) {
  const std::optional<Cone> cone = cone_around(position, spheres, any_width);
  if (!cone) return 0;
  double widest = 0;
  for (const Sphere& sphere : spheres)
    widest = std::max(widest, reach(glm::normalize(glm::dvec3(cone->axis)), position, sphere));
  return std::abs(double(cone->half_angle) - widest);
}

void add_none_rows(Group& group) {
  const glm::vec3 lamp(1, 2, 3);
  group.equals("no spheres", [=] { return found(lamp, {}); }, {0});
  group.equals("the lamp in the middle of a sphere", [=] { return found(lamp, {{lamp, 0.5f}}); }, {0});
  group.equals("the lamp on a sphere's surface",
               [=] {
                 return found(lamp, {{lamp + glm::vec3(0.5f, 0, 0), 0.5f}});
               },
               {0});
  group.equals("the lamp at a sphere of radius 0", [=] { return found(lamp, {{lamp, 0}}); }, {0});
  group.equals("one far, and the lamp within another",
               [=] {
                 return found(lamp, {{lamp + glm::vec3(0, 9, 0), 1}, {lamp + glm::vec3(0.1f, 0, 0), 1}});
               },
               {0});
  group.equals("two opposite spheres, as far as each other and not",
               [=] {
                 Values out = found({0, 0, 0}, {{{0, 3, 0}, 1}, {{0, -3, 0}, 1}});
                 out.push_back(found({0, 0, 0}, {{{0, 3, 0}, 1}, {{0, -700, 0}, 1}})[0]);
                 return out;
               },
               {0, 0});
  group.equals("two spheres 1e-5 rad short of opposite",
               [=] {
                 return found({0, 0, 0}, {{{0, 3, 0}, 1}, {{3e-5f, -3, 0}, 1}});
               },
               {0});
  group.equals("a sphere 1e-25 m away, and one 1e25 m: squares leave the range of floats, so a cube it is",
               [=] {
                 Values out = found({0, 0, 0}, {{{0, 1e-25f, 0}, 1e-26f}});
                 out.push_back(found({0, 0, 0}, {{{0, 1e25f, 0}, 1e24f}})[0]);
                 return out;
               },
               {0, 0});
}

void add_one_sphere_rows(Group& group) {
  group.equals("one sphere of radius 0: the direction, and no angle",
               [] {
                 return found({0, 0, 0}, {{{0, -2, 0}, 0}});
               },
               {1, 0, -1, 0, 0});
  group.close(
      "one sphere a millionth of its radius away: a quarter turn, short of 1.4 mrad",
      {5e-5, "radians", "the ratio is a rounding off, 6e-8, and so near 1 that it counts 1/sqrt(2e-6) = 700 times"},
      [] {
        const std::vector<Sphere> spheres = {{{0, 1.000001f, 0}, 1}};
        return half_angle_error({0, 0, 0}, spheres);
      });
  for (const float size : {1e-15f, 1e-6f, 1e6f, 1e15f})
    group.close(fmt::format("one sphere of {:g} m, two of its radii away", size),
                {4 * rounding_unit, "radians", "a length, a quotient and an arc sine below 1"}, [size] {
                  const std::vector<Sphere> spheres = {{size * glm::vec3(0.6f, -1.6f, 1), size}};
                  return found({0, 0, 0}, spheres)[0] == 1 ? half_angle_error({0, 0, 0}, spheres) : double(INFINITY);
                });
  group.close("1e6 m from the origin, a sphere 2 m away: as floats have them",
              {4 * rounding_unit, "radians", "the difference of these floats is exact"}, [] {
                const glm::vec3 lamp(1e6f, -1e6f, 1e6f);
                return half_angle_error(lamp, {{lamp + glm::vec3(0, -2, 0.5f), 0.25f}});
              });
  group.equals("the widest angle that is allowed: kept just below it, refused just above",
               [] {
                 const std::vector<Sphere> spheres = {{{0, 2, 0}, 1}};  // asin(1/2)
                 return Values{found({0, 0, 0}, spheres, 0.5235989f)[0], found({0, 0, 0}, spheres, 0.5235980f)[0]};
               },
               {1, 0});
}

}  // namespace

void add_cone_rows(Table& table) {
  Group group = table.of("cone_around");
  add_none_rows(group);
  add_one_sphere_rows(group);
  group.close(
      "300 times seven random spheres of 1e-3 to 1e3 m: none sticks out, and the widest touches",
      {8 * rounding_unit, "radians", "an axis and a direction, normalised, and two arcs, at most pi"}, [] {
        return worst_of(300, 410, [](Trial& t) {
          std::vector<Sphere> spheres;
          const double size = t.size_between(1e-3, 1e3);
          const glm::dvec3 somewhere = t.direction();
          for (int i = 0; i < 7; ++i)
            spheres.push_back({glm::vec3(size * (2.0 * somewhere + t.direction())), float(size * t.between(0, 0.9))});
          return half_angle_error({0, 0, 0}, spheres);
        });
      });
}

}  // namespace atelier::stability
