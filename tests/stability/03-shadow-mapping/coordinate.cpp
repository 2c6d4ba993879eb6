// shadow_coordinate and map_width: upon the light and behind it, beyond the far plane, far from the world's origin.
#include "stability/03-shadow-mapping/rows.hpp"

namespace atelier::stability {

using namespace shadow_mapping;

namespace {

class Coordinate {
 public:
  explicit Coordinate(ShaderFunctions& shaders) : shaders_(&shaders) {}
  Values operator()(const LightFrustum& frustum, const glm::vec3& position) const {
    const glm::mat4 m = bias_matrix() * light_projection(frustum) * light_view(frustum);
    const ShaderFunction function = shadow_function({"m0", "m1", "m2", "m3", "position"},
                                                    "vec4(shadow_coordinate(mat4(m0, m1, m2, m3), position.xyz), 0.0)");
    return values(glm::vec3(shaders_->evaluate(function, input_of(m, position))));
  }

 private:
  ShaderFunctions* shaders_;
};

/// A spot 4 m above `origin` that looks down at 45 degrees to each side: what it sees at the floor is 8 m wide.
LightFrustum spot_above(const glm::vec3& origin) {
  return {.eye = origin + glm::vec3(0, 4, 0), .extent = 0.78539816f, .near = 0.5f, .far = 8};
}

void add_coordinate_rows(Group& group, const Coordinate& coordinate) {
  const LightFrustum spot = spot_above({}),
                     sun{.orthographic = true, .eye = {0, 4, 0}, .extent = 2, .near = 0, .far = 4};
  const Values nowhere{0, 0, 2};
  group.equals(
      "upon the light: w = 0",
      [=] {
        return coordinate(spot, {0, 4, 0});
      },
      nowhere);
  group.equals(
      "behind the light",
      [=] {
        return coordinate(spot, {1, 6, 1});
      },
      nowhere);
  group.equals(
      "1e30 m behind the light",
      [=] {
        return coordinate(spot, {0, 1e30f, 0});
      },
      nowhere);
  group.equals("beyond the far plane: as on it", [=] { return Values{coordinate(spot, {0, -20, 0})[2]}; }, {1});
  group.equals("1e30 m beyond the far plane", [=] { return Values{coordinate(spot, {0, -1e30f, 0})[2]}; }, {1});
  group.equals("beyond a sun's far plane", [=] { return Values{coordinate(sun, {0, -20, 0})[2]}; }, {1});
  group.close("before the near plane: below 0, and not lost",
              {1e-6, "absolute", "a quotient of a matrix's entries, 8 (0.25 - 0.5) / (0.25 7.5) = -1.07"}, [=] {
                return std::abs(coordinate(spot, {0, 3.75f, 0})[2] + 16.0 / 15);
              });
  group.finite("a micrometre before the light", [=] { return coordinate(spot, {0, 4 - 1e-6f, 0}); });
  group.nan("a position of NaN", [=] { return coordinate(sun, glm::vec3(not_a_number)); });
}

/// The largest error of u and v over a floor of 7 x 7 m, `offset` metres from the origin.
double floor_error(const Coordinate& coordinate, float offset) {
  const glm::vec3 origin(offset, 0, -offset);
  double worst = 0;
  for (int i = 0; i < 64; ++i) {
    const glm::vec3 place = origin + glm::vec3(i % 8 - 3.5f, 0, i / 8 - 3.5f);
    const glm::dvec3 p = glm::dvec3(place) - glm::dvec3(origin);
    const Values at = coordinate(spot_above(origin), place);
    // Straight down, +x stands in for up (step 01): u runs along +z, v along +x.
    worst = std::max(worst, difference({at[0], at[1]}, {0.5 + p.z / 8, 0.5 + p.x / 8}));
  }
  return worst;
}

}  // namespace

void add_coordinate_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("shadow_coordinate (GLSL)");
  const Coordinate coordinate(shaders);
  add_coordinate_rows(group, coordinate);
  for (const float offset : {0.0f, 1e2f, 1e4f, 1e6f})
    group.close(fmt::format("shadows {:g} m from the origin: u and v on a floor of 8 m", offset),
                {(8 + 4 * double(offset)) * rounding_unit, "of the map's width",
                 "eight metres' own roundings, and of the offset's the matrix's entries and two sums, over 8 m"},
                [=] { return floor_error(coordinate, offset); });

  Group width = table.of("map_width (GLSL)");
  const auto map_width = [&shaders](float half, float depth, bool sun) {
    const ShaderFunction function =
        shadow_function({"in_light", "directional", "depth"}, fmt::format("vec4(map_width({}, depth.x))", plain_light));
    return Values{shaders.number(function, input_of(glm::vec3(half, 1, 2), float(sun), depth))};
  };
  width.equals("a spot at no distance", [=] { return map_width(0.5f, 0, false); }, {0});
  width.equals("a spot at 1e6 m", [=] { return map_width(0.5f, 1e6f, false); }, {1e6});
  width.equals("a spot of 1.5 rad at 1e6 m", [=] { return map_width(14, 1e6f, false); }, {2.8e7});
  width.equals("a sun, 1e6 m and no distance",
               [=] {
                 return Values{map_width(3, 1e6f, true)[0], map_width(3, 0, true)[0]};
               },
               {6, 6});
}

}  // namespace atelier::stability
