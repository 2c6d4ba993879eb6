// blurred: widths of 1e-3 to 20 pixels, pictures of one pixel and of the longest side, a NaN.
#include "image/image.hpp"
#include "stability/08-post-processing/rows.hpp"

namespace atelier::stability {

using post_processing::gaussian_weights;

namespace {

/// A picture, row by row from the bottom; nearest filtering, clamped: as a chain's targets are.
struct Texels {
  int width = 1, height = 1;
  std::vector<glm::vec4> colours;

  Texels(int w, int h, const glm::vec3& fill = glm::vec3(0))
      : width(w), height(h), colours(std::size_t(w) * std::size_t(h), glm::vec4(fill, 1)) {}
  glm::vec4& at(int x, int y) { return colours[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
};

Texels random_texels(int width, int height) {
  Texels texels(width, height);
  for (std::size_t i = 0; i < texels.colours.size(); ++i) {
    Trial t(900, std::int64_t(i));
    texels.colours[i] = glm::vec4(some_colour(t), 1);
  }
  return texels;
}

/// All pixels of the picture blurred in one direction, in the same order.
std::vector<glm::vec4> blurred_texels(ShaderFunctions& shaders, const Texels& texels, float sigma, bool across) {
  Gl& gl = shaders.gl();
  const GlTexture texture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, texels.width, texels.height, 0, GL_RGBA, GL_FLOAT, texels.colours.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);

  const std::vector<float> weights = gaussian_weights(sigma);
  ShaderFunction function = post_function({"texcoord", "pixel"}, "vec4(blurred(u_blurred, texcoord.xy, pixel.xy), 1.0)",
                                          "uniform sampler2D u_blurred;\n");
  function.defines = {{"LAST_WEIGHT", fmt::to_string(weights.size() - 1)}};
  for (std::size_t k = 0; k < weights.size(); ++k)
    function.uniforms[fmt::format("u_weights[{}]", k)] = {double(weights[k])};
  function.textures = {{"u_blurred", texture.id()}};

  const glm::vec2 size(texels.width, texels.height), pixel = (across ? glm::vec2(1, 0) : glm::vec2(0, 1)) / size;
  std::vector<ShaderInput> calls;
  for (int y = 0; y < texels.height; ++y)
    for (int x = 0; x < texels.width; ++x) calls.push_back(input_of((glm::vec2(x, y) + 0.5f) / size, pixel));
  return shaders.evaluate(function, calls);
}

/// The same in double precision, with the same weights: each texel gives to its neighbours, and to those of the ones
/// that it stands for beyond an edge.
std::vector<Colour> exactly_blurred(const Texels& texels, float sigma, bool across) {
  const std::vector<float> weights = gaussian_weights(sigma);
  const int last = int(weights.size()) - 1, length = across ? texels.width : texels.height;
  std::vector<Colour> sums(texels.colours.size(), Colour(0));
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const int x = int(i) % texels.width, y = int(i) / texels.width, place = across ? x : y;
    const int step = across ? 1 : texels.width;
    const int from = place == 0 ? -last : place, to = place == length - 1 ? length - 1 + last : place;
    for (int source = from; source <= to; ++source)
      for (int k = std::max(-last, -source); k <= std::min(last, length - 1 - source); ++k) {
        const int target = int(i) + (source + k - place) * step;
        sums[std::size_t(target)] += double(weights[std::size_t(std::abs(k))]) * Colour(texels.colours[i]);
      }
  }
  return sums;
}

/// The largest error of a pixel, as a share of `size`.
double blur_error(ShaderFunctions& shaders, const Texels& texels, float sigma, bool across) {
  return difference(all_values(blurred_texels(shaders, texels, sigma, across)), [&] {
    std::vector<glm::dvec4> expected;
    for (const Colour& c : exactly_blurred(texels, sigma, across)) expected.emplace_back(c, 1);
    return all_values(expected);
  }());
}

/// Pixels that are NaN, and others that are not what they are without it, around a NaN in the middle of 101 x 5.
Values around_nan(ShaderFunctions& shaders, float sigma, bool across) {
  Texels texels(101, 5, {0.5f, 0.25f, 0.125f});
  const std::vector<glm::vec4> plain = blurred_texels(shaders, texels, sigma, across);
  texels.at(50, 2) = glm::vec4(not_a_number);
  const std::vector<glm::vec4> found = blurred_texels(shaders, texels, sigma, across);
  double broken = 0, changed = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool here = std::isnan(found[i].r);
    broken += here;
    changed += !here && found[i] != plain[i];
  }
  return {broken, changed};
}

}  // namespace

void add_blurred_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("blurred (GLSL)");
  for (const bool across : {true, false}) {
    const char* way = across ? "across" : "up and down";
    const auto words = [=](const std::string& extreme) { return fmt::format("{}: {}", way, extreme); };
    for (const float sigma : {1e-3f, 0.5f, 6.0f, 20.0f})
      for (const float size : {1e-30f, 0.3f, 1.0f, largest_half})
        group.close(
            words(fmt::format("an even picture of {:g}, a width of {:g} pixels", size, sigma)),
            {1e-6, "relative",
             "up to 121 products of positive numbers are summed; their roundings go both ways: a 4000th of a step "
             "of 8 bits"},
            [=, &shaders] {
              const glm::vec3 fill = size * glm::vec3(1, 0.5f, 0.25f);
              double worst = 0;
              for (const glm::vec4& c : blurred_texels(shaders, Texels(40, 40, fill), sigma, across))
                worst = std::max(worst, each_relative(values(glm::vec3(c)), values(fill)));
              return worst;
            });
    for (const auto& [width, height] : {std::pair{1, 1}, {9, 1}, {1, 9}, {64, 48}, {Image::max_side, 1}})
      for (const float sigma : {0.5f, 20.0f})
        group.close(words(fmt::format("a random picture of {} x {}, a width of {:g} pixels", width, height, sigma)),
                    {4 * std::ceil(3 * double(sigma)) * rounding_unit, "absolute",
                     "of up to 1: for each pair of weights a sum, a product and a sum"},
                    [=, &shaders, width = width, height = height] {
                      return blur_error(shaders, random_texels(width, height), sigma, across);
                    });
    group.equals(words("one white pixel, 6 wide: pixels that have not exactly its weight"),
                 [=, &shaders] {
                   Texels texels(65, 65);
                   texels.at(32, 32) = glm::vec4(1);
                   const std::vector<glm::vec4> found = blurred_texels(shaders, texels, 6, across);
                   const std::vector<float> weights = gaussian_weights(6);
                   double others = 0;
                   for (int y = 0; y < 65; ++y)
                     for (int x = 0; x < 65; ++x) {
                       const std::size_t k = std::size_t(std::abs(across ? x - 32 : y - 32));
                       const bool reached = (across ? y : x) == 32 && k < weights.size();
                       others += found[std::size_t(65 * y + x)].r != (reached ? weights[k] : 0.0f);
                     }
                   return Values{others};
                 },
                 {0});
    group.finite(words("a pixel of 1e38 beside black"), [=, &shaders] {
      Texels texels(9, 9);
      texels.at(4, 4) = glm::vec4(1e38f);
      return all_values(blurred_texels(shaders, texels, 20, across));
    });
  }
  // A NaN times a weight is NaN. A picture that is blurred in both directions loses a square: bright_part keeps it out.
  for (const float sigma : {1e-3f, 0.5f, 2.0f}) {
    const double last = std::ceil(3 * double(sigma));
    group.equals(fmt::format("a NaN, a width of {:g}: lost across, others that change", sigma),
                 [=, &shaders] { return around_nan(shaders, sigma, true); }, {2 * last + 1, 0});
    group.equals(fmt::format("a NaN, a width of {:g}: lost up and down, others that change", sigma),
                 [=, &shaders] { return around_nan(shaders, sigma, false); }, {std::min(2 * last + 1, 5.0), 0});
  }
}

}  // namespace atelier::stability
