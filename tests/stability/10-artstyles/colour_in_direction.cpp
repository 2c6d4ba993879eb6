// colour_in_direction: directions of 1e-20 to 1e30 m, beside and behind the eye, at the edges of pictures of all sizes.
#include "stability/10-artstyles/texels.hpp"

namespace atelier::stability {

namespace {

constexpr char expression[] = "vec4(colour_in_direction(u_texels, d.xyz, h.xy), 0.0)";

std::vector<glm::vec4> colours_in(ShaderFunctions& shaders, const Texels& texels,
                                  const std::vector<ShaderInput>& calls) {
  return results_with(shaders, texels, true, {"d", "h"}, expression, calls);
}

/// Where the calls' directions are read, by two pictures of coordinates; black is (0, 0).
std::vector<glm::dvec2> read_places(ShaderFunctions& shaders, const std::vector<ShaderInput>& calls) {
  const std::vector<glm::vec4> x = colours_in(shaders, coordinate_texels(0), calls),
                               y = colours_in(shaders, coordinate_texels(1), calls);
  std::vector<glm::dvec2> out;
  for (std::size_t i = 0; i < calls.size(); ++i) out.emplace_back(x[i].r, y[i].g);
  return out;
}

/// How far the places read are from the right ones, at most. At edges either is right.
double read_places_error(ShaderFunctions& shaders, const std::vector<ShaderInput>& calls) {
  const std::vector<glm::dvec2> found = read_places(shaders, calls);
  double worst = 0;
  for (std::size_t i = 0; i < calls.size(); ++i) {
    const glm::dvec3 d{glm::vec3(calls[i][0])};
    const glm::dvec2 half{glm::vec2(calls[i][1])};
    glm::dvec2 right(0);
    if (d.z < 0) {
      const glm::dvec2 place = glm::dvec2(d) / -d.z / half;
      const double farthest = std::max(std::abs(place.x), std::abs(place.y));
      if (std::abs(farthest - 1) < 1e-5) continue;
      if (farthest < 1) right = {read_coordinate(0.5 * place.x + 0.5), read_coordinate(0.5 * place.y + 0.5)};
    }
    worst = worse_of(worst, glm::length(found[i] - right));
  }
  return worst;
}

/// How many of the directions give anything but black, in a white picture.
Values not_black(ShaderFunctions& shaders, const std::vector<glm::vec3>& directions) {
  std::vector<ShaderInput> calls;
  for (const glm::vec3& d : directions)
    for (const float half : {1e-3f, 1.0f, 1e3f}) calls.push_back(input_of(d, glm::vec2(half)));
  double others = 0;
  for (const glm::vec4& c : colours_in(shaders, Texels(4, 4, glm::vec3(1)), calls)) others += c != glm::vec4(0);
  return {others};
}

const Bound read_bound{read_error + 16 * rounding_unit, "of the picture",
                       "drivers mix the 64 texels a side by weights of at least 8 bits; two quotients and a sum"};

}  // namespace

void add_in_direction_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("colour_in_direction (GLSL)");
  for (const float z : {0.0f, -0.0f, 1e-30f, 1.0f, 1e30f, infinite})
    group.equals(
        fmt::format("z = {:g}: beside or behind the eye, colours that are not black", z),
        [=, &shaders] {
          return not_black(shaders, {{0, 0, z}, {1, 0, z}, {0, -1, z}, {1e-30f, 1e-30f, z}, {1e30f, -1e30f, z}});
        },
        {0});
  group.equals("nearly beside the eye: x or y up to 1e30 times as far as ahead, colours that are not black",
               [&shaders] {
                 return not_black(shaders, {{1, 0, -1e-30f},
                                            {0, -1, -1e-30f},
                                            {-1e30f, 1e30f, -1e-30f},
                                            {2e3f, 0, -1},
                                            {0, 1e30f, -1},
                                            {infinite, 0, -1}});
               },
               {0});
  for (const float length : {1e-30f, 1e-20f, 1e-10f, 1e10f, 1e20f, 1e30f}) {
    group.close(fmt::format("1000 directions, {:g} m long", length), read_bound, [=, &shaders] {
      std::vector<ShaderInput> calls;
      for (int i = 0; i < 1000; ++i) {
        Trial t(1150, i);
        const glm::dvec3 d(t.between(-1.2, 1.2), t.between(-0.8, 0.8), -1);
        calls.push_back(input_of(glm::vec3(double(length) * d), glm::vec2(1, 0.6f)));
      }
      return read_places_error(shaders, calls);
    });
    group.close(fmt::format("straight ahead, {:g} m", length), read_bound, [=, &shaders] {
      return glm::length(read_places(shaders, {input_of(glm::vec3(0, 0, -length), glm::vec2(1))})[0] - 0.5);
    });
  }
  for (const float half : {1e-3f, 1.0f, 1e3f})
    group.close(fmt::format("half sizes of {:g} m and half of it: 1e-5 within the edges and beyond them", half),
                read_bound, [=, &shaders] {
                  std::vector<ShaderInput> calls;
                  for (const float sign : {-1.0f, 1.0f})
                    for (const float off : {-2e-5f, 2e-5f})
                      for (const float other : {-0.7f, 0.0f, 0.4f}) {
                        const glm::vec2 size(half, half / 2);
                        calls.push_back(input_of(glm::vec3(size * glm::vec2(sign * (1 + off), other), -1), size));
                        calls.push_back(input_of(glm::vec3(size * glm::vec2(other, sign * (1 + off)), -1), size));
                      }
                  return read_places_error(shaders, calls);
                });
  group.close("10000 directions all around, half sizes of 0.01 to 100 m", read_bound, [&shaders] {
    std::vector<ShaderInput> calls;
    for (int i = 0; i < 10'000; ++i) {
      Trial t(1151, i);
      const glm::vec3 d(t.size_between(1e-6, 1e6) * t.direction());
      const double x = t.size_between(0.01, 100);
      calls.push_back(input_of(d, glm::vec2(x, t.size_between(0.01, 100))));
    }
    return read_places_error(shaders, calls);
  });
  for (const float light : {1e-30f, 65504.0f, 1e30f})
    group.close(fmt::format("pictures of 1 x 1 and 5 x 3, of {:g} everywhere", light),
                {1e-6, "relative", "the weights of texels sum to 1 up to their roundings"}, [=, &shaders] {
                  double worst = 0;
                  for (const glm::ivec2& size : {glm::ivec2(1, 1), glm::ivec2(5, 3)}) {
                    std::vector<ShaderInput> calls;
                    for (int i = 0; i < 100; ++i) {
                      Trial t(1152, i);
                      const double x = t.between(-0.99, 0.99);
                      calls.push_back(input_of(glm::vec3(x, t.between(-0.99, 0.99), -1), glm::vec2(1)));
                    }
                    for (const glm::vec4& c : colours_in(shaders, Texels(size.x, size.y, glm::vec3(light)), calls))
                      worst = worse_of(worst, each_relative(values(glm::vec3(c)), Values(3, double(light))));
                  }
                  return worst;
                });
  group.equals("a NaN in one of three directions: the others that change",
               [&shaders] {
                 const ShaderInput one = input_of(glm::vec3(0.2f, 0.1f, -1), glm::vec2(1)),
                                   lost = input_of(glm::vec3(not_a_number), glm::vec2(1));
                 const std::vector<glm::dvec2> plain = read_places(shaders, {one, one, one}),
                                               found = read_places(shaders, {one, lost, one});
                 return Values{double(found[0] != plain[0]) + double(found[2] != plain[2])};
               },
               {0});
}

}  // namespace atelier::stability
