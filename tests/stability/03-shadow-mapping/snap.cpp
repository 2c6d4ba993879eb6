// snap_to_texels: maps of one texel and of 8192, far from the origin, of any size; what it must not change.
#include "stability/03-shadow-mapping/rows.hpp"

namespace atelier::stability {

using namespace shadow_mapping;

namespace {

LightFrustum sun_at(const glm::vec3& eye, const glm::vec3& direction, float extent) {
  return {
      .orthographic = true, .eye = eye, .direction = glm::normalize(direction), .extent = extent, .near = 0, .far = 10};
}

/// Right and up of a light's picture, in double precision.
glm::dmat2x3 across(const glm::vec3& direction) {
  const glm::dvec3 ahead(direction), right = glm::normalize(glm::cross(ahead, glm::dvec3(0, 1, 0)));
  return {right, glm::cross(right, ahead)};
}

/// How far the snapped eye is from a whole multiple of a texel, in texels.
double off_grid(const LightFrustum& snapped, int resolution) {
  const glm::dvec2 place = glm::dvec3(snapped.eye) * across(snapped.direction);
  const glm::dvec2 texels = place * double(resolution) / (2.0 * double(snapped.extent));
  return std::max(std::abs(texels.x - std::round(texels.x)), std::abs(texels.y - std::round(texels.y)));
}

Values placed(const LightFrustum& f) {
  return {f.eye.x, f.eye.y, f.eye.z, f.extent, f.near, f.far};
}

void add_size_rows(Group& group) {
  group.same(
      "a pyramid stays as it is",
      [] {
        return placed(snap_to_texels({.eye = {0.3f, 0.7f, 0.1f}, .extent = 0.7f}, 64));
      },
      [] {
        return placed({.eye = {0.3f, 0.7f, 0.1f}, .extent = 0.7f});
      });
  for (const float extent : {1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f})
    group.close(fmt::format("half {:g} m wide: the next of the steps 2^(k/4), with half a texel of room", extent),
                {8 * rounding_unit, "relative", "a power of two with a logarithm's rounding in its exponent"}, [=] {
                  const double needed = double(extent) * (1 + 1.0 / 512);
                  const double step = std::exp2(std::ceil(4 * std::log2(needed)) / 4);
                  return std::abs(snap_to_texels(sun_at({}, {0, -1, 0}, extent), 512).extent / step - 1);
                });
  for (const int resolution : {1, 3, 8192})
    group.close(
        fmt::format("a map of {0} x {0} texels", resolution),
        {resolution * 8 * rounding_unit, "texels", "a length as long as the map, two dot products of it"}, [=] {
          return off_grid(snap_to_texels(sun_at({0.3f, -0.8f, 0.9f}, {1, -2, 0.5f}, 1), resolution), resolution);
        });
}

void add_place_rows(Group& group) {
  for (const float distance : {1e3f, 1e6f})
    group.close(fmt::format("{:g} m from the origin, texels of 4 m", distance),
                {16 * rounding_unit * distance / 4, "texels", "the eye itself, and three dot products of it"}, [=] {
                  const auto snapped = snap_to_texels(sun_at({distance, 10, -distance}, {1, -2, 0.5f}, 500), 256);
                  return off_grid(snapped, 256) * 2 * double(snapped.extent) / 256 / 4;
                });
  group.finite("1e30 m from the origin", [] {
    return placed(snap_to_texels(sun_at(glm::vec3(1e30f), {1, -2, 0.5f}, 1), 1024));
  });
  group.close("1000 random suns: the eye moves by at most half a texel across, and not along",
              {1e-5, "texels", "lengths of up to 1000 texels, in floats: 1000 times 2^-24, twice"}, [] {
                return worst_of(1000, 303, [](Trial& t) {
                  const float extent = float(t.size_between(0.1, 1000));
                  const LightFrustum before = sun_at(glm::vec3(t.in_cube(double(extent))),
                                                     glm::vec3(t.direction()) + glm::vec3(0, 0, 1.5f), extent);
                  const int resolution = 16 + int(t.between(0, 240));
                  const LightFrustum after = snap_to_texels(before, resolution);
                  const double texel = 2 * double(after.extent) / resolution;
                  const glm::dvec3 moved = glm::dvec3(after.eye) - glm::dvec3(before.eye);
                  const glm::dvec2 aside = glm::abs(moved * across(before.direction)) / texel;
                  return std::max({aside.x - 0.5, aside.y - 0.5,
                                   std::abs(glm::dot(moved, glm::dvec3(before.direction))) / texel, 0.0});
                });
              });
  group.equals("1000 random suns that move by less than a texel: the same place, or the next texel's",
               [] {
                 double strange = 0;
                 for (int i = 0; i < 1000; ++i) {
                   Trial t(304, i);
                   LightFrustum frustum = sun_at(glm::vec3(t.in_cube(1)), {1, -2, 0.5f}, 1);
                   const LightFrustum first = snap_to_texels(frustum, 64);
                   const double texel = 2 * double(first.extent) / 64;
                   frustum.eye += glm::vec3(0.5 * texel * t.direction());
                   const LightFrustum second = snap_to_texels(frustum, 64);
                   const glm::dvec2 texels =
                       (glm::dvec3(second.eye) - glm::dvec3(first.eye)) * across(frustum.direction) / texel;
                   const glm::dvec2 rest = glm::abs(texels - glm::round(texels));
                   strange += std::max(rest.x, rest.y) > 1e-4 ||
                              std::max(std::abs(texels.x), std::abs(texels.y)) > 1.5 || first.extent != second.extent;
                 }
                 return Values{strange};
               },
               {0});
}

}  // namespace

void add_snap_rows(Table& table) {
  Group group = table.of("snap_to_texels");
  add_size_rows(group);
  add_place_rows(group);
}

}  // namespace atelier::stability
