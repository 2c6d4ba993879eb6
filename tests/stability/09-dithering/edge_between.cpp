// edge_between: points that are the same, steps and bends on both sides of their limits, distances of 1e-30 to 1e30.
#include "stability/09-dithering/rows.hpp"

namespace atelier::stability {

namespace {

/// A call: a, normal_a, b, normal_b, distance.
ShaderInput edge_call(const glm::dvec3& a, const glm::dvec3& normal_a, const glm::dvec3& b, const glm::dvec3& normal_b,
                      double distance) {
  return input_of(glm::vec3(a), glm::vec3(normal_a), glm::vec3(b), glm::vec3(normal_b), float(distance));
}

/// A unit vector at a right angle to another.
glm::dvec3 some_tangent(Trial& t, const glm::dvec3& normal) {
  for (;;) {
    const glm::dvec3 across = glm::cross(normal, t.direction());
    if (glm::length(across) > 0.1) return across / glm::length(across);
  }
}

/// The normal turned by so many degrees towards `tangent`.
glm::dvec3 turned_normal(const glm::dvec3& normal, const glm::dvec3& tangent, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return std::cos(angle) * normal + std::sin(angle) * tangent;
}

struct Bend {
  double degrees, steps;  ///< between the normals; the lesser height over a tangent plane, as part of the distance
  double apart;           ///< the points, as part of the distance
};

Bend bend_of(const ShaderInput& in) {
  const glm::dvec3 a(in[0]), normal_a(in[1]), b(in[2]), normal_b(in[3]);
  const double distance = double(in[4].x);
  const glm::dvec3 way = (b - a) / distance;
  return {degrees_between(normal_a, normal_b),
          std::min(std::abs(glm::dot(normal_a, way)), std::abs(glm::dot(normal_b, way))), glm::length(way)};
}

/// 1 where a line is missing or too much; 0 within roundings of a limit.
double wrong_edge(const ShaderInput& in, const glm::vec4& out) {
  const Bend bend = bend_of(in);
  const bool near = std::abs(bend.degrees - 30) < 1e-3 || std::abs(bend.steps - 0.01) < 1e-5 + 1e-6 * bend.apart;
  const bool line = bend.degrees > 30 || bend.steps > 0.01;
  return !near && line != (out.x != 0);
}

/// Points in all positions to each other: heights of 0.001 to 0.1 and ways of up to 10 times the distance.
ShaderInput some_edge(Trial& t) {
  const double distance = t.size_between(1e-30, 1e30);
  const glm::dvec3 normal = t.direction(), a = distance * t.in_cube(1);
  const glm::dvec3 tangent = some_tangent(t, normal);
  const double height = t.sign() * t.size_between(1e-3, 0.1), way = t.size_between(1e-3, 10);
  const glm::dvec3 b = a + distance * (height * normal + way * tangent);
  const double degrees = t.between(0, 40);
  return edge_call(a, normal, b, turned_normal(normal, some_tangent(t, normal), degrees), distance);
}

}  // namespace

void add_edge_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("edge_between (GLSL)");
  const ShaderFunction function =
      dither_function({"a", "normal_a", "b", "normal_b", "distance"},
                      "vec4(edge_between(a.xyz, normal_a.xyz, b.xyz, normal_b.xyz, distance.x) ? 1.0 : 0.0)");
  // How many of 1000 calls have a line, or none.
  const auto count = [=, &shaders](bool lines, auto arguments) {
    std::vector<ShaderInput> calls;
    for (int i = 0; i < 1000; ++i) {
      Trial t(990, i);
      calls.push_back(arguments(t));
    }
    const Values found = shaders.numbers(function, calls);
    return Values{double(std::count_if(found.begin(), found.end(), [=](double x) { return (x != 0) == lines; }))};
  };
  for (const double distance : {0.0, 1e-30, 1.0, 1e30}) {
    const auto words = [=](const std::string& what) { return fmt::format("{}, {:g} m away", what, distance); };
    group.equals(words("one point, one normal: 1000 calls with a line"),
                 [=] {
                   return count(true, [=](Trial& t) {
                     const glm::dvec3 normal = t.direction(), a = distance * t.in_cube(1);
                     return edge_call(a, normal, a, normal, distance);
                   });
                 },
                 {0});
    for (const double degrees : {0.0, 10.0, 29.99, 30.01, 90.0, 150.0, 180.0})
      group.equals(words(fmt::format("one point, normals {:g} degrees apart: 1000 calls that are wrong", degrees)),
                   [=] {
                     return count(degrees < 30, [=](Trial& t) {
                       const glm::dvec3 normal = t.direction(), a = distance * t.in_cube(1);
                       return edge_call(a, normal, a, turned_normal(normal, some_tangent(t, normal), degrees),
                                        distance);
                     });
                   },
                   {0});
  }
  for (const double distance : {1e-30, 1e-3, 1.0, 1e6, 1e30}) {
    const auto words = [=](const std::string& what) { return fmt::format("{}, {:g} m away", what, distance); };
    for (const double height : {0.0, 0.00999, 0.01001, 1.0})
      group.equals(words(fmt::format("a step of {:g} of the distance: 1000 calls that are wrong", height)),
                   [=] {
                     return count(height < 0.01, [=](Trial& t) {
                       const glm::dvec3 normal = t.direction(), a = distance * t.in_cube(1);
                       const glm::dvec3 along = t.between(0, 0.1) * some_tangent(t, normal);
                       return edge_call(a, normal, a + distance * (t.sign() * height * normal + along), normal,
                                        distance);
                     });
                   },
                   {0});
    group.equals(words("one plane, 1e-3 to 1000 distances between the points: 1000 calls with a line"),
                 [=] {
                   return count(true, [=](Trial& t) {
                     const glm::dvec3 normal = t.direction(), along = some_tangent(t, normal);
                     return edge_call(glm::dvec3(0), normal, distance * t.size_between(1e-3, 1000) * along, normal,
                                      distance);
                   });
                 },
                 {0});
    // Over a bend of 29 degrees: a point 0.1 distances away is on one tangent plane, and 0.048 from the other.
    for (const bool on_a : {true, false})
      group.equals(words(fmt::format("{} lies on the other's tangent plane: 1000 calls with a line", on_a ? "b" : "a")),
                   [=] {
                     return count(true, [=](Trial& t) {
                       const glm::dvec3 normal = t.direction(), along = some_tangent(t, normal);
                       const glm::dvec3 other = turned_normal(normal, along, 29), a = distance * t.in_cube(0.1);
                       const glm::dvec3 b = a + 0.1 * distance * along;
                       return on_a ? edge_call(a, normal, b, other, distance)
                                   : edge_call(b, other, a, normal, distance);
                     });
                   },
                   {0});
  }
  group.equals(
      "a sharp step between planes that bend by 29 degrees, each point off the other's: 1000 calls without a line",
      [=] {
        return count(false, [=](Trial& t) {
          const glm::dvec3 normal = t.direction(), along = some_tangent(t, normal);
          return edge_call(glm::dvec3(0), normal, normal + 0.1 * along, turned_normal(normal, along, 29), 1);
        });
      },
      {0});
  group.equals("10000 random pairs of points, 1e-30 to 1e30 m away: calls that are wrong",
               [=, &shaders] { return Values{worst_of_calls(shaders, function, 10'000, 991, some_edge, wrong_edge)}; },
               {0});
  group.same(
      "2000 random pairs of points: the same with a and b exchanged",
      [=, &shaders] {
        std::vector<ShaderInput> calls;
        for (int i = 0; i < 2000; ++i) {
          Trial t(992, i);
          calls.push_back(some_edge(t));
        }
        return shaders.numbers(function, calls);
      },
      [=, &shaders] {
        std::vector<ShaderInput> calls;
        for (int i = 0; i < 2000; ++i) {
          Trial t(992, i);
          const ShaderInput in = some_edge(t);
          calls.push_back({in[2], in[3], in[0], in[1], in[4]});
        }
        return shaders.numbers(function, calls);
      });
}

}  // namespace atelier::stability
