#include "10-artstyles/given/probes.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>

#include "02-blinn-phong/given/shaders_alone.hpp"
#include "10-artstyles/artstyles.hpp"
#include "10-artstyles/given/exact_strokes.hpp"
#include "10-artstyles/given/random.hpp"
#include "app/probe_texture.hpp"

namespace atelier {

namespace {

using namespace artstyles;

// ---- GLSL

/// 12 x 8 texels of light, some above 1; in each channel another one changes most. Clamped.
GlTexture test_picture(Gl& gl, GLint filtered) {
  constexpr int width = 12, height = 8;
  std::vector<glm::vec4> texels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      texels.emplace_back(x < 4 ? 0.04f : float((5 * x + 3 * y) % 7) / 8,
                          y < 3 ? 0.25f : float((3 * x + 7 * y) % 11) / 9,
                          (x > 7) == (y > 4) ? 0.9f : 0.1f * float(x % 3), 1.0f);
  GlTexture texture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, texels.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, filtered);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  return texture;
}

std::string glsl() {
  return text_including("10-artstyles/artstyles.glsl", no_lights()) + "uniform sampler2D u_test;\n";
}

Probe picture_probe(GLint filter, const std::string& expression, int components) {
  const auto make = [filter](Gl& gl) { return test_picture(gl, filter); };
  return with_texture(GL_TEXTURE_2D, make, shader_probe(glsl(), expression, components));
}

// ---- Strokes

glm::ivec2 place(const Arguments& in, const char* name) {
  return glm::ivec2(in.vec2(name));
}

/// How many centres, and the first six.
Numbers probe_centres(ProbeContext&, const Arguments& in) {
  const std::vector<glm::ivec2> centres =
      stroke_centres(place(in, "size"), place(in, "cell"), std::uint32_t(in.integer("seed")));
  Numbers out{double(centres.size())};
  for (std::size_t i = 0; i < 6; ++i) append(out, numbers_of(i < centres.size() ? centres[i] : glm::ivec2(-1)));
  return out;
}

/// How many centres there are, and how many of them are not where they should be.
Numbers probe_all_centres(ProbeContext&, const Arguments& in) {
  const glm::ivec2 size = place(in, "size"), cell = place(in, "cell");
  const auto seed = std::uint32_t(in.integer("seed"));
  const std::vector<glm::ivec2> centres = stroke_centres(size, cell, seed);
  const std::vector<glm::ivec2> right = exact_strokes().centres(size, cell, seed);
  double wrong = 0;
  for (std::size_t i = 0; i < right.size(); ++i) wrong += i >= centres.size() || centres[i] != right[i];
  return {double(centres.size()), wrong};
}

/// Greys by the name of a picture.
Greys greys_named(int picture, int width, int height) {
  Greys greys{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto noise = int(random_numbers(10, x, y).x >> 24);
      const std::array<int, 8> values = {0,                                           // black
                                         200,                                         // even
                                         noise,                                       // noise
                                         x < width / 2 ? 40 : 220,                    // a step
                                         255 * x / std::max(width - 1, 1),            // a slope
                                         240 + noise % 8,                             // bright, with little noise
                                         (x / 3 + y / 3) % 2 ? 230 : 20,              // a checker board
                                         y == x || y == x + 1 ? 0 : 90 + noise % 4};  // a dark diagonal
      greys.values.push_back(std::uint8_t(values.at(std::size_t(picture))));
    }
  return greys;
}

Greys greys_named(const Arguments& in) {
  const glm::ivec2 size = place(in, "size");
  return greys_named(in.integer("picture"), size.x, size.y);
}

Numbers probe_radius(ProbeContext&, const Arguments& in) {
  const Brush brush{.smallest = in.integer("smallest"),
                    .largest = in.integer("largest"),
                    .reach = in.integer("reach"),
                    .full = float(in.number("full"))};
  return {double(brush_radius(greys_named(in), place(in, "centre"), brush))};
}

/// A canvas without two equal pixels beside each other.
Picture test_canvas(int width, int height) {
  Picture canvas{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      canvas.pixels.emplace_back((37 * x + 11 * y) % 200, (13 * x + 59 * y) % 200, (71 * x + 5 * y) % 200,
                                 100 + (x + y) % 100);
  return canvas;
}

/// A canvas of 9 x 7 pixels: which pixels of each row have changed, as decimal digits from left to right; and what has
/// become of the pixel at `place`. "regions": 1 if the three columns on the right are another region, and the one
/// before them is a border.
Numbers probe_stroke(ProbeContext&, const Arguments& in) {
  constexpr int width = 9, height = 7;
  const Picture before = test_canvas(width, height);
  Picture canvas = before;
  const glm::dvec3 colour = in.vec3("colour");
  const Stroke stroke{.from = place(in, "from"),
                      .to = place(in, "to"),
                      .radius = in.integer("radius"),
                      .colour = glm::u8vec4(colour.r, colour.g, colour.b, 7),
                      .opacity = in.integer("opacity"),
                      .region = 3};
  std::vector<int> parts;
  if (in.integer("regions"))
    for (int i = 0; i < width * height; ++i) parts.push_back(i % width < 5 ? 3 : i % width == 5 ? 0 : 4);
  paint_stroke(canvas, stroke, {in.integer("first_row"), in.integer("end_row")}, parts);
  Numbers out;
  const glm::ivec2 at = place(in, "place");
  if (canvas.pixels.size() != before.pixels.size()) return Numbers(height + 4, -1);
  for (int y = 0; y < height; ++y) {
    double digits = 0;
    for (int x = 0; x < width; ++x) {
      const auto i = std::size_t(y * width + x);
      digits = 10 * digits + (canvas.pixels[i] != before.pixels[i]);
    }
    out.push_back(digits);
  }
  append(out, numbers_of(canvas.pixels[std::size_t(at.y * width + at.x)]));
  return out;
}

/// How many pixels of a canvas are wrong after a hundred strokes of all lengths and directions.
Numbers probe_strokes(ProbeContext&, const Arguments& in) {
  const glm::ivec2 size = place(in, "size");
  Picture canvas = test_canvas(size.x, size.y), right = canvas;
  std::vector<int> parts;
  for (int i = 0; i < size.x * size.y; ++i) parts.push_back(i % size.x / 5 % 3);
  for (int i = 0; i < 100; ++i) {
    const auto random = [&](int which, int count) {
      return int(random_numbers(std::uint32_t(in.integer("seed")), i, which).x % std::uint32_t(count));
    };
    const glm::ivec2 from(random(0, size.x + 8) - 4, random(1, size.y + 8) - 4);
    const Stroke stroke{.from = from,
                        .to = from + glm::ivec2(random(2, 25) - 12, random(3, 25) - 12),
                        .radius = random(4, 6),
                        .colour = glm::u8vec4(random(5, 256), random(6, 256), random(7, 256), 0),
                        .opacity = random(8, 256),
                        .region = random(9, 3)};
    const Rows rows{random(10, 4), size.y - random(11, 4)};
    const bool everywhere = i % 2 == 0;
    paint_stroke(canvas, stroke, rows, everywhere ? std::vector<int>() : parts);
    exact_strokes().paint(right, stroke, rows, everywhere ? std::vector<int>() : parts);
  }
  double wrong = 0;
  for (std::size_t i = 0; i < right.pixels.size(); ++i)
    wrong += i >= canvas.pixels.size() || canvas.pixels[i] != right.pixels[i];
  return {double(canvas.pixels.size()), wrong};
}

// ---- Regions

/// Numbered by their first pixels: 1, 2 ...; borders 0; what is below 0 stays.
std::vector<int> in_order(const std::vector<int>& numbers) {
  std::map<int, int> known;
  std::vector<int> out;
  for (const int n : numbers) out.push_back(n <= 0 ? n : known.try_emplace(n, int(known.size()) + 1).first->second);
  return out;
}

/// The regions of up to 16 pixels, in the order of their first ones; -1 for pixels that there are not.
Numbers probe_regions(ProbeContext&, const Arguments& in) {
  const std::vector<double>& values = in.numbers("values");
  const int width = in.integer("width");
  const Greys greys{width, int(values.size()) / width, {values.begin(), values.end()}};
  const std::vector<int> found = in_order(regions(greys, in.integer("threshold")));
  Numbers out;
  for (std::size_t i = 0; i < 16; ++i) out.push_back(i < found.size() ? double(found[i]) : -1);
  return out;
}

/// Of a larger picture: how many numbers, how many regions, how many pixels are in a wrong one.
Numbers probe_all_regions(ProbeContext&, const Arguments& in) {
  const Greys greys = greys_named(in);
  const int threshold = in.integer("threshold");
  const std::vector<int> found = in_order(regions(greys, threshold));
  const std::vector<int> right = in_order(exact_strokes().regions(greys, threshold));
  double wrong = 0;
  for (std::size_t i = 0; i < right.size(); ++i) wrong += i >= found.size() || found[i] != right[i];
  return {double(found.size()), double(found.empty() ? 0 : *std::ranges::max_element(found)), wrong};
}

}  // namespace

std::map<std::string, Probe> style_probes() {
  return {
      {"edge_strength", picture_probe(GL_NEAREST, "vec4(edge_strength(u_test, texcoord, pixel))", 1)},
      {"toon", shader_probe(glsl(), "vec4(toon(colour, edge, low, high), 0.0)", 3)},
      {"surface_steps",
       shader_probe(glsl(),
                    "vec4(surface_steps(vec4[9](upper_left, above, upper_right, left, here, right, lower_left, below, "
                    "lower_right)), 0.0, 0.0)",
                    2)},
      {"power_source", shader_probe(glsl(), "vec4(power_source(texcoord, size, strength, power), 0.0, 0.0)", 2)},
      {"fisheye_direction", shader_probe(glsl(), "vec4(fisheye_direction(texcoord, size, half_angle), 0.0)", 3)},
      {"colour_in_direction",
       picture_probe(GL_LINEAR, "vec4(colour_in_direction(u_test, direction, half_size), 0.0)", 3)},
      {"aberrated", picture_probe(GL_LINEAR, "vec4(aberrated(u_test, texcoord, amount, turns), 0.0)", 3)},
      {"fisheye_place", shader_probe(glsl(), "vec4(fisheye_place(direction, size, half_angle), 0.0, 0.0)", 2)},
      {"fisheye_distance",
       shader_probe(
           glsl(),
           "vec4(length((2.0 * fisheye_place(direction, size, half_angle) - 1.0) * vec2(size.x / size.y, 1.0)))", 1)},
      {"power_place", shader_probe(glsl(), "vec4(power_place(source, size, strength, power), 0.0, 0.0)", 2)},
      {"distorted_normal", shader_probe(glsl(), "vec4(distorted_normal(normal, mat2(by_x, by_y)), 0.0)", 3)},
      {"stroke_centres", probe_centres},
      {"all_centres", probe_all_centres},
      {"centres_refuses",
       [](ProbeContext&, const Arguments& in) {
         return refuses([&] { stroke_centres(place(in, "size"), place(in, "cell"), 1); });
       }},
      {"brush_radius", probe_radius},
      {"paint_stroke", probe_stroke},
      {"strokes", probe_strokes},
      {"regions", probe_regions},
      {"all_regions", probe_all_regions},
  };
}

}  // namespace atelier
