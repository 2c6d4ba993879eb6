// light_image: the images of lights, held against the exact maps of portals and mirrors.
#include "stability/07-stencil-portals/rows.hpp"

namespace atelier::stability {

using namespace stencil_portals;

namespace {

/// 10 m from a place.
Light light_near(Trial& t, LightType type, const glm::dvec3& place) {
  Light light;
  light.type = type;
  light.position = place + 10.0 * t.direction();
  light.direction = glm::vec3(t.direction());
  return light;
}

/// Where a map of points takes a direction.
Exact mapped_direction(const Map& exact, const glm::vec3& direction) {
  return exact(Exact(direction)) - exact(Exact(0));
}

/// Adds rows for passages of any kind: make(trial, distance, quarters) is a passage with its exact map.
template <class Make>
void add_rows_through(Group& group, const char* openings, Make make) {
  for (const double distance : {1.0, million}) {
    group.close(fmt::format("1000 odd {} {:g} m away: places of point lights", openings, distance),
                metres(2 * (distance + 10), sums_of_products), [=] {
                  return worst_of(1000, 820, [=](Trial& t) {
                    const auto [passage, exact, place] = make(t, distance, false);
                    const Light light = light_near(t, LightType::point, place);
                    return largest_of(Exact(light_image(light, passage).position) - exact(Exact(light.position)));
                  });
                });
    group.close(
        fmt::format("1000 odd {} {:g} m away: directions of directional lights", openings, distance),
        {2 * rounding_unit, "absolute", "a turn in double precision, rounded; the translation has no part in it"}, [=] {
          return worst_of(1000, 821, [=](Trial& t) {
            const auto [passage, exact, place] = make(t, distance, false);
            const Light light = light_near(t, LightType::directional, place);
            return largest_of(Exact(light_image(light, passage).direction) - mapped_direction(exact, light.direction));
          });
        });
  }
  group.close(fmt::format("1000 odd {} 10 m away, lights 1e30 m away", openings),
              {32 * double_unit, "of that distance", sums_of_products}, [=] {
                return worst_of(1000, 822, [=](Trial& t) {
                  const auto [passage, exact, place] = make(t, 10, false);
                  Light light;
                  light.position = 1e30 * t.direction();
                  return largest_of(Exact(light_image(light, passage).position) - exact(Exact(light.position))) / 1e30;
                });
              });
  group.equals(fmt::format("1000 {} at quarter turns, spot lights at dyadic places: the error", openings),
               [=] {
                 return Values{worst_of(1000, 823, [=](Trial& t) {
                   const auto [passage, exact, place] = make(t, 2048, true);
                   Light light;
                   light.type = LightType::spot;
                   light.position = dyadic_place(t, 2048);
                   light.direction = {0, 0.6f, -0.8f};
                   const Light image = light_image(light, passage);
                   return std::max(
                       largest_of(Exact(image.position) - exact(Exact(light.position))),
                       largest_of(Exact(image.direction) - Exact(glm::vec3(mapped_direction(exact, light.direction)))));
                 })};
               },
               {0});
}

/// A point light on a frame's plane.
Light light_on(Trial& t, const glm::dmat4& frame) {
  Light light;
  light.position = glm::dvec3(at(frame, {t.between(-5, 5), t.between(-5, 5), 0}));
  return light;
}

}  // namespace

void add_image_rows(Table& table) {
  Group group = table.of("light_image");
  add_rows_through(group, "portals", some_portal);
  add_rows_through(group, "mirrors", some_mirror);
  group.close("lights on the entry's plane a million metres away: how far from the exit's plane",
              metres(2 * million, sums_of_products), [] {
                return worst_of(1000, 824, [](Trial& t) {
                  const glm::dmat4 entry = odd_frame(t, million), exit = odd_frame(t, million);
                  const Light image = light_image(light_on(t, entry), portal_passage(entry, exit));
                  return std::abs(double(height_above(exit, Exact(image.position))));
                });
              });
  group.close("lights on a mirror a million metres away stay", metres(2 * million, sums_of_products), [] {
    return worst_of(1000, 825, [](Trial& t) {
      const glm::dmat4 frame = odd_frame(t, million);
      const Light light = light_on(t, frame);
      return largest_of(Exact(light_image(light, mirror_passage(frame)).position) - Exact(light.position));
    });
  });
  group.close("a mirror twice, a million metres away: the light itself",
              metres(4 * million, "two passages one after the other"), [] {
                return worst_of(1000, 826, [](Trial& t) {
                  const glm::dmat4 frame = odd_frame(t, million), passage = mirror_passage(frame);
                  const Light light = light_near(t, LightType::point, glm::dvec3(frame[3]));
                  const Light image = light_image(light_image(light, passage), passage);
                  return largest_of(Exact(image.position) - Exact(light.position));
                });
              });
  group.equals("all else stays",
               [] {
                 Light light;
                 light.type = LightType::spot;
                 light.name = "lamp";
                 light.colour = {largest_float, 0, denormal};
                 light.attenuation = {0, denormal, largest_float};
                 light.inner_angle = 0, light.outer_angle = std::numbers::pi_v<float>;
                 light.casts_shadow = false;
                 const Light image = light_image(light, mirror_passage(glm::dmat4(1)));
                 return Values{double(image.type == LightType::spot),
                               double(image.name == "lamp"),
                               double(image.colour == light.colour),
                               double(image.attenuation == light.attenuation),
                               double(image.inner_angle),
                               double(image.outer_angle),
                               double(image.casts_shadow)};
               },
               {1, 1, 1, 1, 0, double(std::numbers::pi_v<float>), 0});
}

}  // namespace atelier::stability
