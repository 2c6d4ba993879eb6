#include "08-post-processing/given/probes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "08-post-processing/given/cube_texts.hpp"
#include "08-post-processing/post_processing.hpp"
#include "gl/full_screen.hpp"
#include "gl/objects.hpp"
#include "gl/query.hpp"
#include "gl/state.hpp"
#include "gl/target.hpp"

namespace atelier {

namespace {

using namespace post_processing;

const char* const glsl_file = "08-post-processing/post_processing.glsl";

// ---- The chain

/// The vertex arrays that exist, of the lowest names: drivers give free ones first.
int vertex_arrays(Gl& gl) {
  int count = 0;
  for (GLuint id = 1; id <= 1000; ++id) count += gl.IsVertexArray(id) == GL_TRUE;
  return count;
}

/// How many pixels one full-screen pass draws exactly once; whether another vertex array is bound afterwards than
/// before; how many vertices were drawn; how many more vertex arrays there are.
Numbers probe_full_screen(ProbeContext& context, const Arguments& in) {
  Gl& gl = context.gl;
  const glm::ivec2 size(in.vec2("size"));
  const Target target(gl, {.width = size.x, .height = size.y, .depth = DepthFormat::none});
  const FindFile find = [&](const std::string& name) { return context.shaders.find(name); };
  const GlProgram program = build_program(
      gl, assemble_shader_text(find, full_screen_vertex_text, "probe vertex shader", {}),
      assemble_shader_text(find, "out vec4 o; void main() { o = vec4(1.0); }\n", "probe fragment shader", {}));
  reset_state(gl);
  target.bind(gl);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  gl.UseProgram(program.id());
  const GlVertexArray before(gl);
  gl.BindVertexArray(before.id());
  const int arrays = vertex_arrays(gl);
  gl.restart_counts();
  draw_full_screen(gl);
  const auto vertices = gl.counts().vertices;
  const GLint bound = integer_of(gl, GL_VERTEX_ARRAY_BINDING);
  const int left = vertex_arrays(gl) - arrays;
  reset_state(gl);
  check_gl_error(gl, "draw_full_screen");
  const Image drawn = target.read_colour(gl);
  return {double(std::ranges::count_if(drawn.pixels(), [](const Rgba& p) { return p.r == 1; })),
          double(bound != 0 && GLuint(bound) != before.id()), double(vertices), double(left)};
}

/// Whether the triangle covers the whole picture, and whether its corners are counter-clockwise.
Numbers probe_corners(ProbeContext& context, const Arguments& in) {
  std::array<glm::dvec2, 3> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::vec4 found = context.shaders.evaluate(text_including(glsl_file),
                                                     fmt::format("vec4(full_screen_corner({}), 0.0, 0.0)", i), in);
    corners[i] = {double(found.x), double(found.y)};
  }
  /// Twice the area of the triangle of two corners and a point: positive if it is to the left of the way.
  const auto left_of = [&](std::size_t i, const glm::dvec2& point) {
    const glm::dvec2 way = corners[(i + 1) % 3] - corners[i], there = point - corners[i];
    return way.x * there.y - way.y * there.x;
  };
  const double turn = left_of(0, corners[2]);
  bool covers = turn != 0;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (std::size_t i = 0; i < 3; ++i) covers = covers && left_of(i, {x, y}) * turn >= 0;
  return {double(covers), double(turn > 0)};
}

Numbers probe_passes(ProbeContext&, const Arguments& in) {
  const Look look{.bloom = float(in.number("bloom")),
                  .exposure = float(in.number("exposure")),
                  .curve = in.integer("curve"),
                  .hue = float(in.number("hue")),
                  .saturation = float(in.number("saturation")),
                  .brightness = float(in.number("brightness")),
                  .table = in.number("table") > 0.5,
                  .overlay = float(in.number("overlay"))};
  const std::vector<Pass> passes = passes_for(look);
  Numbers out{double(passes.size())};
  for (std::size_t i = 0; i < 5; ++i) out.push_back(i < passes.size() ? double(passes[i]) : -1);
  return out;
}

// ---- Bloom

Numbers probe_weights(ProbeContext&, const Arguments& in) {
  constexpr std::size_t most = 61;
  const std::vector<float> weights = gaussian_weights(float(in.number("sigma")));
  Numbers out{double(weights.size())};
  for (std::size_t i = 0; i < most; ++i) out.push_back(i < weights.size() ? double(weights[i]) : 0);
  return out;
}

GlTexture picture_texture(Gl& gl) {
  constexpr int width = 9, height = 5;
  std::vector<glm::vec4> texels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      texels.emplace_back(float((7 * x + 3 * y) % 11) / 10, float(x) / 8, float(y) / 4, 1.0f);
  GlTexture texture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, texels.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  return texture;
}

/// "place": the texel; "across": 1 along x, 0 along y; "last": LAST_WEIGHT. The weights are no Gaussian.
Numbers probe_blurred(ProbeContext& context, const Arguments& in) {
  Gl& gl = context.gl;
  const int last = in.integer("last");
  std::string weights;
  for (int k = 0; k <= last; ++k) weights += fmt::format("{}{:.9f}", k ? ", " : "", 1.0 / (1 + k) - 0.05 * k);
  gl.ActiveTexture(GL_TEXTURE0);
  const GlTexture texture = picture_texture(gl);
  const std::string preamble = fmt::format(
      "#define LAST_WEIGHT {}\nconst float u_weights[{}] = float[]({});\nuniform float u_table_size;\n"
      "#define POST_INPUTS\n#include \"{}\"\nuniform sampler2D u_test;\n",
      last, last + 1, weights, glsl_file);
  const glm::vec4 found = context.shaders.evaluate(preamble,
                                                   "vec4(blurred(u_test, (place + 0.5) / vec2(9.0, 5.0), across > 0.5 "
                                                   "? vec2(1.0 / 9.0, 0.0) : vec2(0.0, 0.2)), 0.0)",
                                                   in);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return {double(found.r), double(found.g), double(found.b)};
}

// ---- Tables

/// A table with a formula, on a grid of `size` points a side.
GlTexture table_texture(Gl& gl, int size) {
  std::vector<glm::vec4> texels;
  for (int b = 0; b < size; ++b)
    for (int g = 0; g < size; ++g)
      for (int r = 0; r < size; ++r) {
        const glm::dvec3 c = glm::dvec3(r, g, b) / double(size - 1);
        texels.emplace_back(c.r * c.r, c.g * c.b, c.b - 0.3 * c.r * c.g + 0.1 * std::sin(7 * c.r), 1);
      }
  GlTexture texture(gl);
  gl.BindTexture(GL_TEXTURE_3D, texture.id());
  gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA32F, size, size, size, 0, GL_RGBA, GL_FLOAT, texels.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_3D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.TexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
  return texture;
}

Probe probe_table(const std::string& function) {
  return [function](ProbeContext& context, const Arguments& in) {
    Gl& gl = context.gl;
    gl.ActiveTexture(GL_TEXTURE0);
    const int size = in.integer("size");
    const GlTexture texture = table_texture(gl, size);
    Arguments arguments = in;
    arguments.values["u_table_size"] = {double(size)};
    const glm::vec4 found = context.shaders.evaluate(
        fmt::format("#define POST_INPUTS\n#define LAST_WEIGHT 0\nconst float u_weights[1] = float[](1.0);\n"
                    "#include \"{}\"\nuniform sampler3D u_test;\n",
                    glsl_file),
        fmt::format("vec4({}(u_test, colour), 0.0)", function), arguments);
    gl.BindTexture(GL_TEXTURE_3D, 0);
    return Numbers{double(found.r), double(found.g), double(found.b)};
  };
}

/// "file": a number of texts_to_read().
Numbers probe_read(ProbeContext&, const Arguments& in) {
  const CubeText& file = texts_to_read().at(std::size_t(in.integer("file")));
  const ColourTable table = read_table(file.text);
  Numbers out{double(table.size)};
  append(out, numbers_of(table.low));
  append(out, numbers_of(table.high));
  out.push_back(double(table.title == file.title));
  out.push_back(double(table.colours.size()));
  if (table.colours.empty()) return out;
  append(out, numbers_of(table.colours.front()));
  append(out, numbers_of(table.colours.at(table.colours.size() > 1 ? 1 : 0)));
  append(out, numbers_of(table.colours.back()));
  return out;
}

/// Tables to write. 0: plain; 1: with a title; 2: another range; 3: numbers that need all their digits; 4: another
/// range in one channel; 5: the smallest floats, and negative ones.
ColourTable table_to_write(int kind) {
  ColourTable table{.size = kind == 3 ? 3 : 2};
  if (kind == 4) table.low = glm::vec3(0, -1, 0);
  if (kind == 1) table.title = "Evening, by hand";
  if (kind == 2) table.low = glm::vec3(-0.125f, 0, 0.1f), table.high = glm::vec3(1, 2.5f, 0.9f);
  for (int i = 0; i < table.size * table.size * table.size; ++i) {
    const float x = float(i) / 7;
    if (kind == 5)
      table.colours.emplace_back(1.4e-45f * float(i + 1), -1e-40f * x, -1e-7f / (1 + x));
    else
      table.colours.emplace_back(kind == 3 ? glm::vec3(std::sqrt(x), 1e-6f * x + 1e-7f, 1 / (3 + x))
                                           : glm::vec3(x, 1 - x, 0.5f * x));
  }
  return table;
}

/// Whether a reader that is not the student's finds the table again, to the last bit; the number of lines that are
/// neither empty nor comments; whether there is a DOMAIN_MIN, a DOMAIN_MAX, a TITLE.
Numbers probe_write(ProbeContext&, const Arguments& in) {
  const ColourTable table = table_to_write(in.integer("kind"));
  std::istringstream text(write_table(table));
  int lines = 0, size = 0, has_low = 0, has_high = 0, has_title = 0;
  glm::vec3 low(0), high(1);
  std::string title;
  std::vector<glm::vec3> colours;
  const auto three = [](std::istream& words) {
    glm::vec3 colour(NAN);
    std::string word;
    for (int i = 0; i < 3 && words >> word; ++i) colour[i] = std::strtof(word.c_str(), nullptr);
    return colour;
  };
  for (std::string line; std::getline(text, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    std::istringstream words(line);
    std::string first;
    if (!(words >> first) || first[0] == '#') continue;
    ++lines;
    if (first == "TITLE") {
      ++has_title;
      title = line.substr(line.find('"') + 1, line.rfind('"') - line.find('"') - 1);
    } else if (first == "LUT_3D_SIZE") {
      words >> size;
    } else if (first == "DOMAIN_MIN") {
      ++has_low, low = three(words);
    } else if (first == "DOMAIN_MAX") {
      ++has_high, high = three(words);
    } else {
      std::istringstream again(line);
      colours.push_back(three(again));
    }
  }
  const bool same =
      size == table.size && low == table.low && high == table.high && title == table.title && colours == table.colours;
  return {double(same), double(lines), double(has_low), double(has_high), double(has_title)};
}

}  // namespace

std::map<std::string, Probe> post_probes() {
  const std::string glsl = text_including(glsl_file);
  return {
      {"next_target",
       [](ProbeContext&, const Arguments& in) { return Numbers{double(next_target(in.integer("source")))}; }},
      {"target_exists",
       [](ProbeContext&, const Arguments& in) {
         const int target = next_target(in.integer("source"));
         return Numbers{double(target == 0 || target == 1)};
       }},
      {"draw_full_screen", probe_full_screen},
      {"passes_for", probe_passes},
      {"gaussian_weights", probe_weights},
      {"gaussian_refuses",
       [](ProbeContext&, const Arguments& in) {
         return refuses([&] { gaussian_weights(float(in.number("sigma"))); });
       }},
      {"full_screen_corner", probe_corners},
      {"luma", shader_probe(glsl, "vec4(luma(colour))", 1)},
      {"hue_chroma_luma", shader_probe(glsl, "vec4(hue_chroma_luma(colour), 0.0)", 3)},
      {"colour_of", shader_probe(glsl, "vec4(colour_of(hue, chroma, luma_wanted), 0.0)", 3)},
      {"adjusted", shader_probe(glsl, "vec4(adjusted(colour, turns, saturation, brightness), 0.0)", 3)},
      {"reinhard", shader_probe(glsl, "vec4(reinhard(colour, white), 0.0)", 3)},
      {"filmic", shader_probe(glsl, "vec4(filmic(colour), 0.0)", 3)},
      {"tone_mapped", shader_probe(glsl, "vec4(tone_mapped(colour, stops, int(curve), white), 0.0)", 3)},
      {"overlaid", shader_probe(glsl, "overlaid(below, above, amount)", 4)},
      {"bright_part", shader_probe(glsl, "vec4(bright_part(colour, threshold), 0.0)", 3)},
      {"blurred", probe_blurred},
      {"table_trilinear", probe_table("table_trilinear")},
      {"table_tetrahedral", probe_table("table_tetrahedral")},
      {"dithered", shader_probe(glsl, "vec4(dithered(stored, noise), 0.0)", 3)},
      {"read_table", probe_read},
      {"read_refuses",
       [](ProbeContext&, const Arguments& in) {
         const std::string& text = texts_to_judge().at(std::size_t(in.integer("file")));
         return refuses([&] { read_table(text); });
       }},
      {"write_table", probe_write},
  };
}

}  // namespace atelier
