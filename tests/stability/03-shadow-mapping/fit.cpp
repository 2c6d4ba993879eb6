// fit_spot and fit_directional: lights within, upon and far away from what they are fitted to; spheres of no size and
// of all.
#include "stability/03-shadow-mapping/rows.hpp"

namespace atelier::stability {

using namespace shadow_mapping;

namespace {

Values turned(const LightFrustum& f) {
  return {f.direction.x, f.direction.y, f.direction.z, f.extent, f.near, f.far};
}

struct SpotCase {
  const char* words;
  glm::vec3 position;
  float outer;  ///< radians
  Sphere sphere;
  Values expected;  ///< direction, half-angle, near, far
};

void add_spot_rows(Group& group) {
  // All lights look down their own way, -z; spheres lie around the origin.
  const float wide = 1.4f;
  const SpotCase exact[] = {
      {"the light in the sphere's middle", {0, 0, 0}, wide, {{0, 0, 0}, 2}, {0, 0, -1, double(wide), 0.002f, 2}},
      {"the light on the sphere", {0, 0, 2}, wide, {{0, 0, 0}, 2}, {0, 0, -1, double(wide), 0.004f, 4}},
      {"the sphere behind a light within it", {0, 0, -1}, wide, {{0, 0, 0}, 2}, {0, 0, -1, double(wide), 0.001f, 1}},
      {"a cone narrower than the sphere, which stands behind the light",
       {0, 0, -5},
       0.1f,
       {{0, 0, 0}, 2},
       {0, 0, -1, double(0.1f), 1e-9f, 1e-6f}},
      {"a sphere without size", {0, 0, 4}, wide, {{0, 0, 0}, 0}, {0, 0, -1, double(0.001f), 4, 4}},
      {"a cone of 0 degrees", {0, 0, 1}, 0, {{0, 0, 0}, 2}, {0, 0, -1, double(0.001f), 0.003f, 3}},
      {"a cone of 180 degrees around a light within the sphere",
       {0, 0, 1},
       float(std::numbers::pi),
       {{0, 0, 0}, 2},
       {0, 0, -1, 1.5, 0.003f, 3}},
      {"straight above", {0, 4, 0}, wide, {{0, 0, 0}, 2}, {0, -1, 0, std::asin(0.5), 2, 6}},
  };
  for (const SpotCase& c : exact)
    group.close(c.words, {4 * rounding_unit, "absolute", "a sum, a quotient and an arc sine of small numbers"}, [c] {
      return difference(turned(fit_spot(c.position, {0, 0, -1}, c.outer, c.sphere)), c.expected);
    });
  for (const float length : {1e-15f, 1e15f})
    group.close(
        fmt::format("a direction {:g} long", length), {2 * rounding_unit, "absolute", "a square root and a quotient"},
        [=] {
          return difference(turned(fit_spot({0, 0, 0}, length * glm::vec3(0, -1, 0), 1, {})), {0, -1, 0, 1, 0.001f, 1});
        });
}

/// The largest relative error of half-angle, near and far of a light that looks at a sphere.
double looking_error(const glm::vec3& position, const Sphere& sphere) {
  const glm::dvec3 way = glm::dvec3(sphere.centre) - glm::dvec3(position);
  const double d = glm::length(way), r = double(sphere.radius), far = d + r;
  const LightFrustum f = fit_spot(position, glm::vec3(way), 1.5f, sphere);
  const Values expected{std::clamp(std::asin(r / d), 0.001, 1.5), std::max(d - r, far / 1000), far};
  return std::max(each_relative({f.extent, f.near, f.far}, expected), difference(values(f.direction), values(way / d)));
}

void add_spot_size_rows(Group& group) {
  const Bound bound{16 * rounding_unit, "relative", "a length of differences, its quotients, and an arc sine"};
  for (const float radius : {1e-6f, 1e-3f, 1e3f, 1e6f})
    group.close(fmt::format("a sphere of {:g} m, three of its radii away", radius), bound, [=] {
      return looking_error(radius * glm::vec3(2, 2, 1), {{0, 0, 0}, radius});
    });
  group.close("a sphere of 1 m, a million metres away", bound, [] {
    return looking_error({6e5f, 8e5f, 0}, {{0, 0, 0}, 1});
  });
  group.close("light and sphere a million metres from the origin, 5 m apart", bound, [] {
    return looking_error({1e6f, 4, 3}, {{1e6f, 0, 0}, 1});
  });
  group.close("1000 random spheres, 1 mm to 1 km, from 1.05 to 100 radii away",
              {16 * rounding_unit / std::sqrt(1 - 1 / (1.05 * 1.05)) / 0.05, "relative",
               "as for one, over the arc sine's slope and over the 5 % that distance and radius are apart"},
              [] {
                return worst_of(1000, 301, [](Trial& t) {
                  const double radius = t.size_between(1e-3, 1e3);
                  const glm::dvec3 position = radius * t.size_between(1.05, 100) * t.direction();
                  return looking_error(glm::vec3(position), {{0, 0, 0}, float(radius)});
                });
              });
  group.close("1000 random spheres, the light within: near and far, over the sphere's radius",
              {8 * rounding_unit, "radii", "a dot product of three, and a sum"}, [] {
                return worst_of(1000, 302, [](Trial& t) {
                  const double radius = t.size_between(1e-3, 1e3);
                  const glm::vec3 position(0.99 * radius * t.between(0, 1) * t.direction()), axis(t.direction());
                  const LightFrustum f = fit_spot(position, axis, 1, {{0, 0, 0}, float(radius)});
                  const double far = glm::dot(-glm::dvec3(position), glm::normalize(glm::dvec3(axis))) + radius;
                  return difference({f.near / radius, f.far / radius}, {far / 1000 / radius, far / radius});
                });
              });
}

void add_sun_rows(Group& group) {
  const auto sun = [](const glm::vec3& direction, const Sphere& sphere) {
    const LightFrustum f = fit_directional(direction, sphere);
    return Values{f.eye.x, f.eye.y, f.eye.z, f.extent, f.near, f.far, double(f.orthographic)};
  };
  group.equals("a sphere without size",
               [=] {
                 return sun({0, -1, 0}, {{0, 0, 0}, 0});
               },
               {0, double(1e-6f), 0, double(1e-6f), 0, double(2e-6f), 1});
  group.equals("a sphere of a million metres",
               [=] {
                 return sun({0, -1, 0}, {{0, 0, 0}, 1e6f});
               },
               {0, 1e6, 0, 1e6, 0, 2e6, 1});
  group.equals("a sphere of 1 m a million metres from the origin",
               [=] {
                 return sun({0, -1, 0}, {{1e6f, 0, -1e6f}, 1});
               },
               {1e6, 1, -1e6, 1, 0, 2, 1});
  for (const float length : {1e-15f, 1e15f})
    group.equals(fmt::format("a direction {:g} long", length),
                 [=] {
                   return sun({0, 0, -length}, {});
                 },
                 {0, 0, 1, 1, 0, 2, 1});
}

}  // namespace

void add_fit_rows(Table& table) {
  Group spot = table.of("fit_spot");
  add_spot_rows(spot);
  add_spot_size_rows(spot);
  Group sun = table.of("fit_directional");
  add_sun_rows(sun);
}

}  // namespace atelier::stability
