// fisheye_place: there and back over all the sphere and all the circle, angles of 1e-6 rad, straight behind, directions
// of any length.
#include "stability/10-artstyles/rows.hpp"

namespace atelier::stability {

namespace {

constexpr glm::vec2 wide(1920, 1080);

/// What the arc tangent of a driver may be off, relative: GLSL demands nothing. Mesa's is a polynomial that is 2.1e-5
/// off at small angles.
constexpr double arc_error = 4e-5;

ShaderInput place_call(const glm::vec3& direction, const glm::vec2& size, float half_angle) {
  return input_of(direction, size, half_angle);
}

double angle_from_axis(const glm::dvec3& d) {
  return std::atan2(std::hypot(d.x, d.y), -d.z);
}

/// How far the place is from the exact one, as a share of what is allowed. Straight behind only the distance counts.
double place_error(const ShaderInput& in, const glm::vec4& out) {
  const glm::vec2 size(in[1]);
  const glm::dvec3 d(in[0]);
  const double r = angle_from_axis(d) / double(in[2].x), across = std::hypot(d.x, d.y);
  const double allowed = r * (arc_error + 8 * rounding_unit) + 2 * texcoord_rounding(glm::vec2(out), size);
  const glm::dvec2 found = place_of(glm::vec2(out), size);
  if (across == 0) return std::abs(glm::length(found) - r) / allowed;
  return glm::length(found - glm::dvec2(d) * (r / across)) / allowed;
}

/// Directions on a grid: 84 angles from the axis, 146 directions around it, all of this length.
std::vector<ShaderInput> grid_of_directions(float half_angle, double length) {
  std::vector<ShaderInput> calls;
  for (const glm::dvec2& at : polar_grid(std::numbers::pi)) {
    const glm::dvec3 d(std::sin(at.x) * std::cos(at.y), std::sin(at.x) * std::sin(at.y), -std::cos(at.x));
    calls.push_back(place_call(glm::vec3(length * d), wide, half_angle));
  }
  return calls;
}

/// Of a direction that has come back, as a share of what is allowed: beyond the circle it is none.
double direction_back_error(const ShaderInput& in, const glm::vec4& out) {
  const glm::dvec3 d(in[0]), back(out);
  const double angle = angle_from_axis(d), half_angle = double(in[2].x);
  if (back == glm::dvec3(0)) return angle > half_angle * (1 - 1e-4) ? 0 : 2;
  if (angle > half_angle * (1 + 1e-4)) return 2;
  const double allowed = angle * arc_error + 2 * sine_error + 4 * half_angle * texcoord_rounding(glm::vec2(1), wide);
  return degrees_between(d, back) * std::numbers::pi / 180 / allowed;
}

/// Of a place that has come back, as a share of what is allowed.
double place_back_error(const ShaderInput& in, const glm::vec4& out) {
  const glm::vec2 size(in[1]);
  const glm::dvec2 place = place_of(glm::vec2(in[0]), size), back = place_of(glm::vec2(out), size);
  const double r = glm::length(place);
  const double allowed = r * (arc_error + 8 * rounding_unit) + 3 * sine_error / double(in[2].x) +
                         8 * texcoord_rounding(glm::vec2(1), size);
  return glm::length(back - place) / allowed;
}

const std::string round_trip_reason =
    "a driver's arc tangent is taken as good to 4e-5 of the angle, its sine and cosine to 2e-6; texture coordinates "
    "are "
    "rounded to 2^-24, and so are some products";

void add_round_trips(Group& group, ShaderFunctions& shaders, const ShaderFunction& function) {
  const ShaderFunction there_and_back = style_function(
      {"d", "size", "angle"}, "vec4(fisheye_direction(fisheye_place(d.xyz, size.xy, angle.x), size.xy, angle.x), 0.0)");
  const ShaderFunction place_and_back = style_function(
      {"texcoord", "size", "angle"},
      "vec4(fisheye_place(fisheye_direction(texcoord.xy, size.xy, angle.x), size.xy, angle.x), 0.0, 0.0)");
  for (const float half_angle : {0.01f, 0.5f, pi / 2, 2.5f, pi}) {
    const auto words = [=](const char* what) { return fmt::format("half an angle of {:.7g}: {}", half_angle, what); };
    group.equals(words("12264 directions all around: places that fail"),
                 [=, &shaders] {
                   return Values{count_failed(shaders, function, grid_of_directions(half_angle, 1), place_error)};
                 },
                 {0});
    group.close(
        words("12264 directions all around: the worst place"),
        {1, "of what is allowed",
         "a driver's arc tangent is taken as good to 4e-5 of the angle; texture "
         "coordinates are rounded to 2^-24"},
        [=, &shaders] { return worst_result(shaders, function, grid_of_directions(half_angle, 1), place_error); });
    group.equals(
        words("12264 directions all around, to their places and back: those that fail"),
        [=, &shaders] {
          return Values{count_failed(shaders, there_and_back, grid_of_directions(half_angle, 1), direction_back_error)};
        },
        {0});
    group.close(words("the same: the worst direction"), {1, "of what is allowed", round_trip_reason}, [=, &shaders] {
      return worst_result(shaders, there_and_back, grid_of_directions(half_angle, 1), direction_back_error);
    });
    for (const glm::vec2& size : {wide, glm::vec2(1, 1), glm::vec2(600, 800)}) {
      const auto calls = [=] {
        std::vector<ShaderInput> all;
        for (const glm::dvec2& at : polar_grid(0.9999))
          all.push_back(
              input_of(texcoord_of(at.x * glm::dvec2(std::cos(at.y), std::sin(at.y)), size), size, half_angle));
        return all;
      };
      const std::string sized =
          fmt::format("{:g} x {:g}, 12264 places of the circle, to their directions and back", size.x, size.y);
      group.equals(words((sized + ": those that fail").c_str()),
                   [=, &shaders] { return Values{count_failed(shaders, place_and_back, calls(), place_back_error)}; },
                   {0});
      group.close(words((sized + ": the worst").c_str()), {1, "of what is allowed", round_trip_reason},
                  [=, &shaders] { return worst_result(shaders, place_and_back, calls(), place_back_error); });
    }
  }
}

}  // namespace

void add_fisheye_place_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("fisheye_place (GLSL)");
  const ShaderFunction function =
      style_function({"d", "size", "angle"}, "vec4(fisheye_place(d.xyz, size.xy, angle.x), 0.0, 0.0)");
  add_round_trips(group, shaders, function);
  const Bound bound{1, "of what is allowed",
                    "a driver's arc tangent is taken as good to 4e-5 of the angle; texture coordinates are rounded to "
                    "2^-24"};
  for (const double length : {1e-12, 1e-6, 1e6, 1e12})
    group.close(fmt::format("12264 directions all around, {:g} m long", length), bound, [=, &shaders] {
      return worst_result(shaders, function, grid_of_directions(pi / 2, length), place_error);
    });
  for (const float half_angle : {1e-4f, 0.01f, pi})
    for (const double angle : {1e-6, 0.001 * std::numbers::pi / 180, 1e-4})
      group.close(fmt::format("half an angle of {:.7g}: 1000 directions, {:.3g} rad from the axis", half_angle, angle),
                  bound, [=, &shaders] {
                    return worst_of_calls(
                        shaders, function, 1000, 1170,
                        [=](Trial& t) {
                          const double a = t.between(0, 2 * std::numbers::pi);
                          const glm::dvec3 d(std::sin(angle) * glm::dvec2(std::cos(a), std::sin(a)), -std::cos(angle));
                          return place_call(glm::vec3(d), wide, half_angle);
                        },
                        place_error);
                  });
  for (const float half_angle : {0.01f, 0.5f, pi}) {
    group.equals(
        fmt::format("half an angle of {:.7g}: straight ahead is exactly the centre", half_angle),
        [=, &shaders] {
          Values all = values(shaders.evaluate(function, place_call({0, 0, -1}, wide, half_angle)));
          const Values far = values(shaders.evaluate(function, place_call({-0.0f, -0.0f, -1e12f}, wide, half_angle)));
          all.insert(all.end(), far.begin(), far.end());
          return all;
        },
        {0.5, 0.5, 0, 0, 0.5, 0.5, 0, 0});
    group.close(fmt::format("half an angle of {:.7g}: straight behind, and nearly", half_angle), bound, [=, &shaders] {
      std::vector<ShaderInput> calls;
      for (const glm::vec3& d : {glm::vec3(0, 0, 1), glm::vec3(-0.0f, 0, 1), glm::vec3(0, -0.0f, 1e12f),
                                 glm::vec3(1e-6f, 0, 1), glm::vec3(0, -1e-6f, 1), glm::vec3(-1e-12f, 1e-12f, 1e-3f)})
        calls.push_back(place_call(d, wide, half_angle));
      return worst_result(shaders, function, calls, place_error);
    });
    group.close(fmt::format("half an angle of {:.7g}: exactly beside the eye", half_angle), bound, [=, &shaders] {
      std::vector<ShaderInput> calls;
      for (const float z : {0.0f, -0.0f})
        for (const glm::vec2& d : {glm::vec2(1, 0), glm::vec2(-1, 0), glm::vec2(0, 1), glm::vec2(0, -1)})
          calls.push_back(place_call(glm::vec3(d, z), wide, half_angle));
      return worst_result(shaders, function, calls, place_error);
    });
  }
  add_nan_row(group, shaders, function, place_call({0.3f, -0.2f, -1}, wide, 1));
}

}  // namespace atelier::stability
