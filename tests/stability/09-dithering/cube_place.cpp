// cube_place: directions of 1e-30 and 1e30, axes, edges, corners and the floats beside edges.
#include "stability/09-dithering/rows.hpp"

namespace atelier::stability {

namespace {

constexpr double eighth_turn = std::numbers::pi / 4;

/// What drivers make of the two angles. The narrowest cells are 1/1000 of a face.
Bound angle_bound(const char* unit) {
  return {1e-5, unit,
          "GLSL does not say how good an arc tangent is; Mesa's polynomial of degree 11 is off by up to 3.4e-6 "
          "radians, and each place has two"};
}

/// The direction that a place stands for.
glm::dvec3 direction_of(const glm::vec4& place) {
  const int face = int(place.z), axis = face / 2;
  glm::dvec3 direction(0);
  direction[axis] = face % 2 == 0 ? 1 : -1;
  direction[(axis + 1) % 3] = std::tan(double(place.x) * eighth_turn);
  direction[(axis + 2) % 3] = std::tan(double(place.y) * eighth_turn);
  return direction;
}

/// The angle between a direction and the one that its place stands for, radians; infinite for a place on no face.
double way_back(const ShaderInput& in, const glm::vec4& place) {
  const bool on_face = place.z == std::round(place.z) && place.z >= 0 && place.z <= 5;
  const double beyond = std::max(std::abs(double(place.x)), std::abs(double(place.y))) - 1;
  if (!on_face || !(beyond < 1e-5)) return double(INFINITY);
  const glm::dvec3 direction(in[0]);
  return degrees_between(direction / glm::length(direction), direction_of(place)) * std::numbers::pi / 180;
}

/// The face of the largest component; -1 where two are equal.
int face_of(const glm::vec3& direction) {
  const glm::vec3 size = glm::abs(direction);
  for (int axis = 0; axis < 3; ++axis)
    if (size[axis] > size[(axis + 1) % 3] && size[axis] > size[(axis + 2) % 3])
      return 2 * axis + (direction[axis] < 0 ? 1 : 0);
  return -1;
}

/// How far a place is from the exact one; the face counts as much as the whole of it.
double place_error(const ShaderInput& in, const glm::vec4& place) {
  const glm::dvec3 direction(in[0]);
  const int face = face_of(glm::vec3(in[0])), axis = face / 2;
  if (face < 0) return 0;
  const double own = std::abs(direction[axis]);
  const glm::dvec3 expected(std::atan2(direction[(axis + 1) % 3], own) / eighth_turn,
                            std::atan2(direction[(axis + 2) % 3], own) / eighth_turn, face);
  return difference(values(glm::vec3(place)), values(expected));
}

/// All directions with components of -1, 0 and 1 of which so many are not 0.
std::vector<glm::vec3> whole_directions(int not_zero) {
  std::vector<glm::vec3> directions;
  for (int i = 0; i < 27; ++i) {
    const glm::vec3 direction(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (glm::dot(direction, direction) == float(not_zero)) directions.push_back(direction);
  }
  return directions;
}

/// The directions of edges and corners with one component moved to the next float, up or down: it is the largest, or no
/// longer.
std::vector<glm::vec3> beside_edges() {
  std::vector<glm::vec3> directions;
  for (const int not_zero : {2, 3})
    for (const glm::vec3& edge : whole_directions(not_zero))
      for (int axis = 0; axis < 3; ++axis)
        for (const float size : {std::nextafter(1.0f, 0.0f), std::nextafter(1.0f, 2.0f)}) {
          glm::vec3 beside = edge;
          beside[axis] *= size;
          directions.push_back(beside);
        }
  return directions;
}

/// Directions at equal angles once around an axis, from the middle of a face: how far the places are from equal steps.
double uneven_steps(ShaderFunctions& shaders, const ShaderFunction& function, int axis) {
  constexpr int steps = 4096, on_face = steps / 4;
  std::vector<ShaderInput> calls;
  for (int i = 0; i < steps; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / steps;
    glm::vec3 direction(0);
    direction[(axis + 1) % 3] = float(std::cos(angle));
    direction[(axis + 2) % 3] = float(std::sin(angle));
    calls.push_back(input_of(direction));
  }
  const std::vector<glm::vec4> places = shaders.evaluate(function, calls);
  double worst = 0;
  for (int i = 0; i < steps; ++i) {
    const glm::dvec4 place(places[std::size_t(i)]);
    const int face = int(place.z);
    const bool first = face / 2 == (axis + 1) % 3;  // the other axis of the plane is then x, and else y
    // On the negative faces, and from the second axis towards the first, the way runs backwards.
    const double sign = (face % 2 == 0) == first ? 1 : -1;
    const double along = 2.0 * ((i + on_face / 2) % on_face + 0.5) / on_face - 1;
    worst = worse_of(worst, std::abs((first ? place.x : place.y) - sign * along));
    worst = worse_of(worst, std::abs(first ? place.y : place.x));
  }
  return worst;
}

}  // namespace

void add_place_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("cube_place (GLSL)");
  const ShaderFunction function = dither_function({"direction"}, "vec4(cube_place(direction.xyz), 0.0)");
  const auto worst = [=, &shaders](const std::vector<glm::vec3>& directions, float length, auto error) {
    std::vector<ShaderInput> calls;
    for (const glm::vec3& direction : directions) calls.push_back(input_of(length * direction));
    const std::vector<glm::vec4> places = shaders.evaluate(function, calls);
    double most = 0;
    for (std::size_t i = 0; i < calls.size(); ++i) most = worse_of(most, error(calls[i], places[i]));
    return most;
  };
  group.close("(2, 1, -0.5): face 0", {1e-4, "of half a face", "the contract's numbers have four digits"},
              [=, &shaders] {
                const glm::vec3 place(shaders.evaluate(function, input_of(glm::vec3(2, 1, -0.5f))));
                return difference(values(place), {0.5903, -0.3119, 0});
              });
  for (const float length : {1e-30f, 1.0f, 1e30f}) {
    const auto words = [=](const char* what) { return fmt::format("{}, {:g} long", what, length); };
    group.equals(words("six axes: the middles of faces"),
                 [=, &shaders] {
                   std::vector<glm::vec3> places;
                   for (int face = 0; face < 6; ++face) {
                     glm::vec3 direction(0);
                     direction[face / 2] = face % 2 == 0 ? length : -length;
                     places.emplace_back(shaders.evaluate(function, input_of(direction)));
                   }
                   return all_values(places);
                 },
                 {0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0, 5});
    group.close(words("twelve edges: back to the direction, from either face"), angle_bound("radians"),
                [=] { return worst(whole_directions(2), length, way_back); });
    group.close(words("eight corners: back to the direction, from any face"), angle_bound("radians"),
                [=] { return worst(whole_directions(3), length, way_back); });
    group.close(words("edges and corners with a component of the next float"), angle_bound("of half a face"),
                [=] { return worst(beside_edges(), length, place_error); });
  }
  group.equals("edges and corners with a component of the next float: wrong faces",
               [=] {
                 return Values{worst(beside_edges(), 1, [](const ShaderInput& in, const glm::vec4& place) {
                   const int face = face_of(glm::vec3(in[0]));
                   return double(face >= 0 && float(face) != place.z);
                 })};
               },
               {0});
  const auto some_direction = [](Trial& t) {
    const double length = t.size_between(1e-30, 1e30);
    return input_of(glm::vec3(length * t.direction()));
  };
  group.close("10000 random directions, lengths of 1e-30 to 1e30: the place", angle_bound("of half a face"),
              [=, &shaders] { return worst_of_calls(shaders, function, 10'000, 980, some_direction, place_error); });
  group.close("10000 random directions, lengths of 1e-30 to 1e30: back to the direction", angle_bound("radians"),
              [=, &shaders] { return worst_of_calls(shaders, function, 10'000, 981, some_direction, way_back); });
  group.close("10000 random directions with a component of 1e-30 to 1e-6: the place", angle_bound("of half a face"),
              [=, &shaders] {
                return worst_of_calls(
                    shaders, function, 10'000, 982,
                    [](Trial& t) {
                      glm::vec3 direction(t.direction());
                      direction[int(t.between(0, 3))] = float(t.sign() * t.size_between(1e-30, 1e-6));
                      return input_of(direction);
                    },
                    place_error);
              });
  for (int axis = 0; axis < 3; ++axis)
    group.close(fmt::format("4096 directions at equal angles around {}: equal steps", "xyz"[axis]),
                angle_bound("of half a face"), [=, &shaders] { return uneven_steps(shaders, function, axis); });
  for (const float factor : {0x1p-99f, 0x1p+99f})
    group.same(
        fmt::format("1000 random directions {:g} times as long: the same places", factor),
        [=, &shaders] {
          std::vector<ShaderInput> calls;
          for (int i = 0; i < 1000; ++i) calls.push_back(input_of(factor * glm::vec3(Trial(983, i).direction())));
          return all_values(shaders.evaluate(function, calls));
        },
        [=, &shaders] {
          std::vector<ShaderInput> calls;
          for (int i = 0; i < 1000; ++i) calls.push_back(input_of(glm::vec3(Trial(983, i).direction())));
          return all_values(shaders.evaluate(function, calls));
        });
  add_nan_row(group, shaders, function, input_of(glm::vec3(2, 1, -0.5f)));
}

}  // namespace atelier::stability
