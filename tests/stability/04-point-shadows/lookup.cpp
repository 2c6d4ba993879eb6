// cube_texel, compare_cube_distance, cube_pcf: no direction, directions along axes, on and beside edges and corners, of
// every length.
#include "stability/04-point-shadows/rows.hpp"

namespace atelier::stability {

namespace {

constexpr float beside = 1e-6f;

/// One call of `expression` a direction, with a cube of 8 x 8 texels a face; `reference` is its second parameter.
Values asked(ShaderFunctions& shaders, const Lookup& lookup, const std::string& expression,
             const std::vector<glm::vec3>& directions, float reference, const std::array<float, 6>& faces) {
  const OwnedCube cube = filled_cube(shaders.gl(), 8, GL_DEPTH_COMPONENT32F, lookup.compare, faces);
  ShaderFunction function = lookup_function({"direction", "reference"}, expression, lookup);
  function.cubes = {{"u_cube_0", cube.texture.id()}};
  std::vector<ShaderInput> inputs;
  for (const glm::vec3& direction : directions) inputs.push_back(input_of(direction, reference));
  return shaders.numbers(function, inputs);
}

constexpr const char* one_comparison = "vec4(compare_cube_distance(0, direction.xyz, reference.x))";
constexpr const char* many_comparisons = "vec4(cube_pcf(CubeLight(vec3(0.0), 1.0, 0), direction.xyz, reference.x))";

void add_edge_rows(Group& group, ShaderFunctions& shaders, const char* expression, const Lookup& lookup) {
  const std::vector<glm::vec3> near_edges = directions_near_edges(beside);
  const auto ask = [=, &shaders](float reference, const std::array<float, 6>& faces) {
    return asked(shaders, lookup, expression, near_edges, reference, faces);
  };
  const std::string name = fmt::format("{}{}", lookup.compare ? "bilinear" : "nearest",
                                       lookup.pcf > 1 ? fmt::format(", {0}x{0}", lookup.pcf) : "");
  group.equals(name + ": on edges and corners and 1e-6 beside them, all faces alike: no line of light, none of shadow",
               [=] {
                 return Values{count_others(ask(0.4f, all_half), {1}), count_others(ask(0.6f, all_half), {0})};
               },
               {0, 0});
  group.equals(name + ": where +x is near and all else far, answers stay from 0 to 1",
               [=] {
                 return Values{count_outside(ask(0.5f, {0.25f, 0.75f, 0.75f, 0.75f, 0.75f, 0.75f}), 0, 1)};
               },
               {0});
}

void add_length_rows(Group& group, ShaderFunctions& shaders, const char* expression, const Lookup& lookup) {
  const std::string name = lookup.compare ? "bilinear" : "nearest";
  group.equals(name + ": no direction at all is lit",
               [=, &shaders] {
                 return Values{
                     count_others(asked(shaders, lookup, expression, {{0, 0, 0}, {-0.0f, 0, 0}}, 0.6f, all_half), {1})};
               },
               {0});
  // Below 1e-19 the square of a length is no normal number, and where it is 0 the answer is that of no direction.
  group.equals(
      name + ": lengths from 1e-30 to 1e18 m, along axes and not: neither NaN nor a mixture",
      [=, &shaders] {
        std::vector<glm::vec3> directions;
        for (int power = -120; power <= 72; ++power)
          for (const glm::vec3& d : {glm::vec3(1, 0, 0), {0, -1, 0}, {0, 0, 1}, {0.5f, -0.7f, 0.9f}, {1, 1, 1}})
            directions.push_back(std::pow(10.0f, float(power) / 4) * d);
        return Values{count_others(asked(shaders, lookup, expression, directions, 0.6f, all_half), {0, 1})};
      },
      {0});
}

/// Nine comparisons around each of the six axes, on a cube of one texel a face that is far on one face and near on all
/// others. A square that spreads both ways has its middle on the face ahead, one, two or three of its nine on each face
/// beside it (those on a corner may fall on either), and none on the face behind. How many of the 36 answers are
/// others.
double count_spread_otherwise(ShaderFunctions& shaders) {
  ShaderFunction function = lookup_function({"direction", "reference"}, many_comparisons, {.pcf = 3});
  double others = 0;
  for (int far = 0; far < 6; ++far) {
    std::array<float, 6> faces{};
    faces[std::size_t(far)] = 1;
    const OwnedCube cube = filled_cube(shaders.gl(), 1, GL_DEPTH_COMPONENT32F, false, faces);
    function.cubes = {{"u_cube_0", cube.texture.id()}};
    for (int ahead = 0; ahead < 6; ++ahead) {
      glm::vec3 along(0);
      along[ahead / 2] = ahead % 2 ? -3.0f : 3.0f;
      const double on_far = 9 * shaders.number(function, input_of(along, 0.5f));
      const int least = ahead == far || ahead / 2 != far / 2 ? 1 : 0;
      const int most = ahead / 2 != far / 2 ? 3 : least;
      others += !(std::round(on_far) >= least && std::round(on_far) <= most);
    }
  }
  return others;
}

void add_texel_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("cube_texel (GLSL)");
  const ShaderFunction function =
      lookup_function({"direction", "resolution"}, "vec4(cube_texel(direction.xyz, resolution.x))");
  const auto texel = [&shaders, function](const glm::vec3& direction, float resolution) {
    return shaders.number(function, input_of(direction, resolution));
  };
  group.equals(
      "no direction; a corner; one texel a face; 1e30 m away",
      [=] {
        return Values{texel({0, 0, 0}, 64), texel({-2, 2, -2}, 64), texel({0, -3, 1}, 1), texel({0, 0x1p100f, 0}, 2)};
      },
      {0, 0.0625, 6, 0x1p100});
  group.close("1000 random directions of 1e-6 to 1e6 m and resolutions",
              {3 * rounding_unit, "relative", "a quotient: 2.5 ulp in GLSL"}, [=, &shaders] {
                std::vector<ShaderInput> inputs;
                Values expected;
                for (int i = 0; i < 1000; ++i) {
                  Trial t(430, i);
                  const glm::vec3 d(t.size_between(1e-6, 1e6) * t.direction());
                  const float resolution = float(int(t.size_between(1, 4097)));
                  inputs.push_back(input_of(d, resolution));
                  const glm::dvec3 a = glm::abs(glm::dvec3(d));
                  expected.push_back(2 * std::max(a.x, std::max(a.y, a.z)) / double(resolution));
                }
                return each_relative(shaders.numbers(function, inputs), expected);
              });
}

}  // namespace

void add_lookup_rows(Table& table, ShaderFunctions& shaders) {
  add_texel_rows(table, shaders);
  Group comparison = table.of("compare_cube_distance (GLSL)"), pcf = table.of("cube_pcf (GLSL)");
  for (const bool compare : {false, true}) {
    add_length_rows(comparison, shaders, one_comparison, {.compare = compare});
    add_edge_rows(comparison, shaders, one_comparison, {.compare = compare});
    for (const int size : {1, 4, 15}) {
      if (size == 4) add_length_rows(pcf, shaders, many_comparisons, {.pcf = size, .compare = compare});
      if (size > 1) add_edge_rows(pcf, shaders, many_comparisons, {.pcf = size, .compare = compare});
    }
  }
  pcf.equals("along each axis: the square of directions spreads to all four sides",
             [&shaders] { return Values{count_spread_otherwise(shaders)}; }, {0});
  comparison.equals("a reference just as stored, and a float above and below it",
                    [&shaders] {
                      Values out;
                      for (const float reference : {0.5f, std::nextafter(0.5f, 0.0f), std::nextafter(0.5f, 1.0f)})
                        out.push_back(asked(shaders, {}, one_comparison, {{1, 0, 0}}, reference, all_half)[0]);
                      return out;
                    },
                    {1, 1, 0});
  comparison.equals("nothing drawn, the farthest reference: lit, at 16 and 24 bits and in floats",
                    [&shaders] {
                      Values out;
                      for (const GLenum format : {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32F}) {
                        const OwnedCube cube = filled_cube(shaders.gl(), 1, format, false, {1, 1, 1, 1, 1, 1});
                        ShaderFunction function =
                            lookup_function({"direction"}, "vec4(compare_cube_distance(0, direction.xyz, 1.0))");
                        function.cubes = {{"u_cube_0", cube.texture.id()}};
                        out.push_back(shaders.number(function, input_of(glm::vec3(1, 2, 3))));
                      }
                      return out;
                    },
                    {1, 1, 1});
  Group stored = table.of("a cube of 16 bits");
  stored.close(
      "distances up to 1e6 m: what is read back",
      {1.01 * 1e6 / 65535, "metres", "65535 steps are 15.26 m each, and drivers round or cut off"}, [&shaders] {
        return worst_of(40, 431, [&](Trial& t) {
          const float share = float(t.between(0, 1));
          const OwnedCube cube =
              filled_cube(shaders.gl(), 1, GL_DEPTH_COMPONENT16, false, {share, share, share, share, share, share});
          ShaderFunction function = lookup_function({"direction"}, "vec4(stored_in_cube(0, direction.xyz))");
          function.cubes = {{"u_cube_0", cube.texture.id()}};
          return 1e6 * std::abs(shaders.number(function, input_of(glm::vec3(t.direction()))) - double(share));
        });
      });
}

}  // namespace atelier::stability
