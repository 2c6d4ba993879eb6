// edge_strength: black, white and even pictures, steps in each direction and channel, the greatest magnitude, light of
// -1e30 to 1e30, pictures of one pixel, row or column, a NaN.
#include "stability/10-artstyles/texels.hpp"

namespace atelier::stability {

namespace {

const Bound edge_bound{64 * rounding_unit, "absolute",
                       "of up to 4.5: drivers round a root of up to 1 to some of its last places, which count with "
                       "weights of 8 in all, and the sums and the length are rounded"};

/// Of all pixels, row by row from the bottom.
Values edges_of(ShaderFunctions& shaders, const Texels& texels) {
  std::vector<ShaderInput> calls;
  for (int y = 0; y < texels.height; ++y)
    for (int x = 0; x < texels.width; ++x)
      calls.push_back(input_of((glm::vec2(x, y) + 0.5f) / texels.size(), 1.0f / texels.size()));
  Values out;
  for (const glm::vec4& v : results_with(shaders, texels, false, {"texcoord", "pixel"},
                                         "vec4(edge_strength(u_texels, texcoord.xy, pixel.xy))", calls))
    out.push_back(double(v.x));
  return out;
}

/// In double precision, as differences of smoothed rows and columns.
double exact_edge(const Texels& texels, int x, int y) {
  double most = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const auto shown = [&](int dx, int dy) {
      return std::sqrt(std::clamp(double(texels.clamped(x + dx, y + dy)[channel]), 0.0, 1.0));
    };
    const auto column = [&](int dx) { return shown(dx, -1) + 2 * shown(dx, 0) + shown(dx, 1); };
    const auto row = [&](int dy) { return shown(-1, dy) + 2 * shown(0, dy) + shown(1, dy); };
    most = std::max(most, std::hypot(column(1) - column(-1), row(1) - row(-1)));
  }
  return most;
}

Values exact_edges(const Texels& texels) {
  Values out;
  for (int y = 0; y < texels.height; ++y)
    for (int x = 0; x < texels.width; ++x) out.push_back(exact_edge(texels, x, y));
  return out;
}

/// All patterns of black and white of the eight neighbours: 16 x 16 pictures of 3 x 3 pixels.
Texels all_patterns() {
  Texels texels(48, 48);
  for (int pattern = 0; pattern < 256; ++pattern)
    for (int neighbour = 0; neighbour < 8; ++neighbour) {
      const int place = neighbour < 4 ? neighbour : neighbour + 1;
      if (pattern >> neighbour & 1)
        texels.at(3 * (pattern % 16) + place % 3, 3 * (pattern / 16) + place / 3) = glm::vec4(1);
    }
  return texels;
}

/// Of the middle pixels of the patterns.
Values middles_of(const Values& all) {
  Values out;
  for (std::size_t y = 1; y < 48; y += 3)
    for (std::size_t x = 1; x < 48; x += 3) out.push_back(all[48 * y + x]);
  return out;
}

/// 16 x 16: beyond the middle, in the direction of an axis or against it, the light of one channel is `light`.
Texels step_texels(int axis, bool backward, int channel, float light) {
  Texels texels(16, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      if (((axis == 0 ? x : y) >= 8) != backward) texels.at(x, y)[channel] = light;
  return texels;
}

void add_even_rows(Group& group, ShaderFunctions& shaders) {
  for (const float light : {0.0f, -1e30f, -1.0f, 0.25f, 1.0f, 1.0000001f, 65504.0f, 1e30f, infinite})
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {9, 1}, {33, 20}})
      group.equals(fmt::format("an even picture of {:.9g}, {} x {}: pixels whose edge is not 0", light, width, height),
                   [=, &shaders, width = width, height = height] {
                     return Values{count_others(edges_of(shaders, Texels(width, height, glm::vec3(light))), {0})};
                   },
                   {0});
  group.close("200 even pictures of any light from 0 to 1", edge_bound, [&shaders] {
    return worst_of(200, 1101, [&](Trial& t) {
      const double r = t.between(0, 1), g = t.between(0, 1);
      const Values found = edges_of(shaders, Texels(3, 3, glm::vec3(r, g, t.between(0, 1))));
      return difference(found, Values(found.size(), 0));
    });
  });
}

void add_step_rows(Group& group, ShaderFunctions& shaders) {
  for (int axis = 0; axis < 2; ++axis)
    for (const bool backward : {false, true})
      for (int channel = 0; channel < 3; ++channel)
        for (const float light : {1.0f, 1e30f}) {
          Values expected;
          for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) {
              const int place = axis == 0 ? x : y;
              expected.push_back(place == 7 || place == 8 ? 4 : 0);
            }
          group.close(fmt::format("a step {} from {:g} to {:g}, {} alone: 4 on both sides of it, 0 elsewhere",
                                  axis == 0 ? "across" : "upwards", backward ? light : 0.0f, backward ? 0.0f : light,
                                  std::array{"red", "green", "blue"}[std::size_t(channel)]),
                      edge_bound, [=, &shaders] {
                        return difference(edges_of(shaders, step_texels(axis, backward, channel, light)), expected);
                      });
        }
  group.close("all 256 patterns of black and white around a pixel", edge_bound, [&shaders] {
    const Texels texels = all_patterns();
    return difference(middles_of(edges_of(shaders, texels)), middles_of(exact_edges(texels)));
  });
  group.close("the greatest of them: the root of 20", edge_bound, [&shaders] {
    const Values found = middles_of(edges_of(shaders, all_patterns()));
    return std::abs(*std::ranges::max_element(found) - std::sqrt(20.0));
  });
  group.close("one white pixel: 0 there, 2 beside it, the root of 2 at its corners", edge_bound, [&shaders] {
    Texels texels(3, 3);
    texels.at(1, 1) = glm::vec4(1);
    const double corner = std::numbers::sqrt2;
    // Beyond the edges the picture goes on: pixels there count as black.
    return difference(edges_of(shaders, texels), {corner, 2, corner, 2, 0, 2, corner, 2, corner});
  });
}

}  // namespace

void add_edge_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("edge_strength (GLSL)");
  add_even_rows(group, shaders);
  add_step_rows(group, shaders);
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 64}, {64, 1}, {2, 2}, {100, 60}, {16384, 1}, {1, 16384}})
    for (const auto& [low, high] : {std::pair{0.0, 1.0}, {-1.0, 2.0}, {0.5, 0.5001}, {-1e30, 1e30}})
      group.close(fmt::format("a random picture, {} x {}, of {:g} to {:g}", width, height, low, high), edge_bound,
                  [=, &shaders, width = width, height = height, low = low, high = high] {
                    const Texels texels = random_texels(width, height, low, high);
                    return difference(edges_of(shaders, texels), exact_edges(texels));
                  });
  group.equals("a NaN in the middle of 9 x 9: others than its neighbours and itself that change",
               [&shaders] {
                 Texels texels = random_texels(9, 9, 0, 1);
                 const Values plain = edges_of(shaders, texels);
                 texels.at(4, 4) = glm::vec4(not_a_number);
                 const Values found = edges_of(shaders, texels);
                 double changed = 0;
                 for (int i = 0; i < 81; ++i) {
                   const bool near = std::max(std::abs(i % 9 - 4), std::abs(i / 9 - 4)) <= 1;
                   changed += !near && found[std::size_t(i)] != plain[std::size_t(i)];
                 }
                 return Values{changed};
               },
               {0});
}

}  // namespace atelier::stability
