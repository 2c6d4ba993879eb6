#include "gl/target.hpp"

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "catch.hpp"
#include "contexts.hpp"
#include "gl/full_screen.hpp"
#include "gl/query.hpp"
#include "gl/shader.hpp"
#include "image/colour.hpp"
#include "shader_text.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;
using atelier::test::on_every_context;
using atelier::test::shader_text;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

bool same(float a, float b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

/// Fills columns x..x+width and OpenGL's rows y..y+height, counted from the bottom, with `value`.
void fill(Gl& gl, int x, int y, int width, int height, const Rgba& value) {
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(x, y, width, height);
  gl.ClearBufferfv(GL_COLOR, 0, &value.r);
  gl.Disable(GL_SCISSOR_TEST);
}

/// Three corners in clip space.
using Corners = std::array<glm::vec2, 3>;
constexpr Corners everything{{{-1, -1}, {3, -1}, {-1, 3}}};
constexpr Corners slanted{{{-1, -1}, {0.9f, -1}, {-0.7f, 1}}};  ///< no edge but the outer ones meets pixels evenly

/// Draws one triangle of one colour at a depth of -1..1 in clip space.
void draw_triangle(Gl& gl, const Corners& corners, float depth, const Rgba& colour) {
  const GlProgram program =
      build_program(gl,
                    shader_text("uniform vec2 u_corners[3]; uniform float u_depth;\n"
                                "void main() { gl_Position = vec4(u_corners[gl_VertexID], u_depth, 1.0); }"),
                    shader_text("uniform vec4 u_colour; out vec4 o; void main() { o = u_colour; }"));
  gl.UseProgram(program.id());
  gl.Uniform2fv(gl.GetUniformLocation(program.id(), "u_corners"), 3, &corners[0].x);
  gl.Uniform1f(gl.GetUniformLocation(program.id(), "u_depth"), depth);
  gl.Uniform4fv(gl.GetUniformLocation(program.id(), "u_colour"), 1, &colour.r);
  draw_triangle_by_id(gl);
}

/// What `value` becomes when it is drawn and read.
float through(Gl& gl, const Target& target, float value) {
  target.bind(gl);
  const Rgba wanted{value, value, value, 1};
  gl.ClearBufferfv(GL_COLOR, 0, &wanted.r);
  return target.read_colour(gl).at(0, 0).g;
}

}  // namespace

TEST_CASE("All floats are read back as they were drawn") {
  on_every_context([](Gl& gl) {
    const float values[] = {0,
                            1,
                            -1,
                            2.5f,
                            1e30f,
                            -1e30f,
                            1e-30f,
                            0.1f,
                            infinity,
                            -infinity,
                            not_a_number,
                            std::numeric_limits<float>::max(),
                            std::numeric_limits<float>::denorm_min()};
    const Target target(gl, {.width = 2, .height = 2});
    for (const float value : values) {
      INFO(value);
      target.bind(gl);
      const Rgba wanted{value, 0.5f, value, value};
      gl.ClearBufferfv(GL_COLOR, 0, &wanted.r);
      const Rgba got = target.read_colour(gl).at(1, 1);
      CHECK(same(got.r, value));
      CHECK(got.g == 0.5f);
      CHECK(same(got.a, value));
    }
  });
}

TEST_CASE("A shader's NaN, infinity, values above one and below zero are read back") {
  on_every_context([](Gl& gl) {
    const GlProgram program = build_program(
        gl, shader_text(full_screen_vertex_text),
        shader_text(
            "uniform float u_zero;\nout vec4 o;\nvoid main() { o = vec4(u_zero / u_zero, 1.0 / u_zero, 7.5, -2.0); }"));
    const Target target(gl, {.width = 1, .height = 1, .depth = DepthFormat::none});
    target.bind(gl);
    gl.UseProgram(program.id());
    draw_triangle_by_id(gl);
    const Rgba got = target.read_colour(gl).at(0, 0);
    CHECK(std::isnan(got.r));
    CHECK(got.g == infinity);
    CHECK(got.b == 7.5f);
    CHECK(got.a == -2.0f);
  });
}

TEST_CASE("For every size, each pixel is read back in its place, with row 0 on top") {
  on_every_context([](Gl& gl) {
    const std::pair<int, int> sizes[] = {{1, 1},   {1, 7},     {7, 1},    {2, 3},    {3, 2},     {5, 5},
                                         {17, 31}, {641, 479}, {4096, 3}, {3, 4096}, {16384, 1}, {1, 16384}};
    for (const auto& [width, height] : sizes) {
      INFO(width << "x" << height);
      const Target target(gl, {.width = width, .height = height});
      target.bind(gl);
      const Rgba base{0.25f, 0.25f, 0.25f, 1}, mark{9, 8, 7, 6};
      gl.ClearBufferfv(GL_COLOR, 0, &base.r);
      fill(gl, width - 1, height - 1, 1, 1, mark);  // OpenGL's last row and column: the upper right corner
      const Image image = target.read_colour(gl);
      REQUIRE(image.width() == width);
      REQUIRE(image.height() == height);
      int marks = 0, others = 0;
      for (const Rgba& pixel : image.pixels()) ++(pixel == mark ? marks : pixel == base ? others : marks += 1000000);
      CHECK(marks == 1);
      CHECK(others == width * height - 1);
      CHECK(image.at(width - 1, 0) == mark);
    }
  });
}

TEST_CASE("Reading does not depend on other OpenGL state") {
  on_every_context([](Gl& gl) {
    const Target target(gl, {.width = 3, .height = 3, .depth = DepthFormat::depth32f}), other(gl, {});
    target.bind(gl);
    const Rgba value{0.5f, 0.25f, 0.125f, 1};
    gl.ClearBufferfv(GL_COLOR, 0, &value.r);
    gl.ClearDepth(0.75);
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    other.bind(gl);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 8);
    const Image colour = target.read_colour(gl);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 8);
    const Image depth = target.read_depth(gl);
    for (int i = 0; i < 9; ++i) {
      CHECK(colour.at(i % 3, i / 3) == value);
      CHECK(depth.at(i % 3, i / 3) == Rgba{0.75f, 0.75f, 0.75f, 1});
    }
    GLint bound = 0;
    gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    CHECK(GLuint(bound) == other.framebuffer());
  });
}

TEST_CASE("Creating a target keeps the bindings") {
  on_every_context([](Gl& gl) {
    const Target first(gl, {.width = 8, .height = 8});
    first.bind(gl);
    gl.BindTexture(GL_TEXTURE_2D, first.colour_texture());
    const Target second(gl, {.width = 4, .height = 4});
    GLint framebuffer = 0, texture = 0;
    gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    gl.GetIntegerv(GL_TEXTURE_BINDING_2D, &texture);
    CHECK(GLuint(framebuffer) == first.framebuffer());
    CHECK(GLuint(texture) == first.colour_texture());
  });
}

TEST_CASE("Colour formats have the precision of their bits") {
  struct Row {
    ColourFormat format;
    float value, kept;
    double tolerance;
    const char* reason;
  };
  const Row rows[] = {
      {ColourFormat::rgba8, 0.3f, 0.3f, 0.5 / 255 + 1e-6, "half a step of 8 bits"},
      {ColourFormat::rgba8, 5.0f, 1.0f, 0, "8 bits end at one"},
      {ColourFormat::rgba16f, 0.3f, 0.3f, 0.25 / 1024,
       "a step of half floats above 0.25: drivers may cut rather than round"},
      {ColourFormat::rgba16f, 1000.0f, 1000.0f, 0, "a whole number below 2048 is exact"},
      {ColourFormat::rgba32f, 0.3f, 0.3f, 0, "the very float"},
  };
  on_every_context([&](Gl& gl) {
    for (const Row& row : rows) {
      const Target target(gl, {.width = 3, .height = 1, .colour = row.format});
      INFO(to_string(target.spec()) << ": " << row.reason);
      target.bind(gl);
      const Rgba value{row.value, row.value, row.value, 1};
      gl.ClearBufferfv(GL_COLOR, 0, &value.r);
      CHECK(std::abs(double(target.read_colour(gl).at(2, 0).g) - row.kept) <= row.tolerance);
    }
  });
}

TEST_CASE("Colours between 0 and 1 are read back with the error of their format") {
  struct Row {
    ColourFormat format;
    double (*error)(double kept, double drawn);
    double most;
    const char* reason;
  };
  const auto codes = [](double kept, double drawn) { return 255 * std::abs(kept - drawn); };
  const auto relative = [](double kept, double drawn) { return std::abs(kept - drawn) / drawn; };
  const auto srgb_codes = [](double kept, double drawn) {
    return 255 * std::abs(srgb_encode(kept) - srgb_encode(drawn));
  };
  const Row rows[] = {
      {ColourFormat::rgba8, codes, 0.5 + 1e-3, "half a code, and the rounding of floats"},
      {ColourFormat::srgb8, srgb_codes, 0.6,
       "half a code, and the tenth that Direct3D's specification leaves to drivers"},
      {ColourFormat::rgba16f, relative, 0x1p-10, "ten bits: half of it where the driver rounds, all where it cuts"},
      {ColourFormat::rgba32f, relative, 0, "the very float"},
  };
  on_every_context([&](Gl& gl) {
    for (const Row& row : rows) {
      const Target target(gl, {.colour = row.format, .depth = DepthFormat::none});
      INFO(to_string(target.spec()) << ": " << row.reason);
      double worst = 0;
      for (int i = 1; i <= 1000; ++i)  // from 1/1000 on halves are no denormals
        worst = std::max(worst, row.error(through(gl, target, float(i) / 1000), float(i) / 1000));
      CHECK(worst <= row.most);
      CHECK(worst >= row.most / 3);  // and it is that format: a finer one would have less
      CHECK(through(gl, target, 0) == 0);
      CHECK(through(gl, target, 1) == 1);
    }
  });
}

TEST_CASE("srgb8 encodes every write, and clamps to 0..1") {
  on_every_context([](Gl& gl) {
    const Target target(gl, {.width = 2, .height = 1, .colour = ColourFormat::srgb8, .depth = DepthFormat::none});
    // The exact code of 0.25 is 136.96: whoever errs by less than 0.5 of a code stores 137.
    const float kept = linear_of_code(137);
    CHECK(through(gl, target, 0.25f) == kept);
    CHECK(through(gl, target, 7) == 1);
    CHECK(through(gl, target, -1) == 0);
    gl.ClearColor(0.25f, 0.25f, 0.25f, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    CHECK(target.read_colour(gl).at(1, 0) == Rgba{kept, kept, kept, 1});
    draw_triangle(gl, everything, 0, {1, 0.25f, 0, 0.5f});
    const Rgba drawn = target.read_colour(gl).at(1, 0);
    CHECK(drawn.r == 1);
    CHECK(drawn.g == kept);
    CHECK(drawn.b == 0);
    CHECK(std::abs(drawn.a - 0.5f) <= 0.5f / 255 + 1e-6f);  // opacity is not encoded

    const Target other(gl, {});
    other.bind(gl);
    CHECK_FALSE(gl.IsEnabled(GL_FRAMEBUFFER_SRGB));  // of those that hold what is written
    target.bind(gl);
    CHECK(gl.IsEnabled(GL_FRAMEBUFFER_SRGB));
  });
}

TEST_CASE("With 4 samples an edge pixel mixes both colours by quarters") {
  struct Row {
    ColourFormat format;
    double tolerance;
    const char* reason;
  };
  const Row rows[] = {
      {ColourFormat::rgba32f, 0, "quarters of 0.5 and 0.25 are floats"},
      {ColourFormat::rgba16f, 0, "and half floats"},
      {ColourFormat::rgba8, 1.0 / 255, "half a code of each colour, and half of the mean"},
      {ColourFormat::srgb8, 1.2 / 255 * 1.7, "the same in codes of sRGB, which are at most 1.7 times as far apart"},
  };
  const Rgba under{0.25f, 0.25f, 0.25f, 1}, over{0.5f, 0.5f, 0.5f, 1};
  on_every_context([&](Gl& gl) {
    for (const Row& row : rows) {
      const TargetSpec spec{.width = 32, .height = 24, .colour = row.format, .samples = 4};
      INFO(to_string(spec) << ": " << row.reason);
      const Target target(gl, spec);
      target.bind(gl);
      gl.ClearBufferfv(GL_COLOR, 0, &under.r);
      draw_triangle(gl, slanted, 0, over);
      const Image picture = target.read_colour(gl);
      int counts[5] = {};
      for (const Rgba& pixel : picture.pixels()) {
        const double quarters = (pixel.r - 0.25) * 16;
        const int nearest = int(std::lround(quarters));
        REQUIRE(nearest >= 0);
        REQUIRE(nearest <= 4);
        CHECK(std::abs(quarters - nearest) <= row.tolerance * 16);
        ++counts[nearest];
      }
      CHECK(counts[0] > 200);  // below, above, and every mix between
      CHECK(counts[4] > 200);
      for (const int mixed : {counts[1], counts[2], counts[3]}) CHECK(mixed > 3);
    }
  });
}

TEST_CASE("With 4 samples the depth is that of one sample, in every format") {
  const DepthFormat formats[] = {DepthFormat::depth16, DepthFormat::depth24, DepthFormat::depth32f,
                                 DepthFormat::depth24_stencil8, DepthFormat::depth32f_stencil8};
  on_every_context([&](Gl& gl) {
    for (const DepthFormat format : formats)
      for (const ColourFormat colour : {ColourFormat::none, ColourFormat::rgba32f}) {
        const Target target(gl, {.width = 32, .height = 24, .colour = colour, .depth = format, .samples = 4});
        INFO(to_string(target.spec()));
        target.bind(gl);
        gl.ClearDepth(1);
        gl.Clear(GL_DEPTH_BUFFER_BIT);
        gl.Enable(GL_DEPTH_TEST);
        draw_triangle(gl, slanted, -0.5f, {1, 1, 1, 1});
        gl.Disable(GL_DEPTH_TEST);
        const Image depth = target.read_depth(gl);
        int near = 0, far = 0;
        for (const Rgba& pixel : depth.pixels()) {
          near += std::abs(pixel.r - 0.25f) < 1e-5f;  // half a step of 16 bits
          far += pixel.r == 1;
        }
        CHECK(near > 200);
        CHECK(far > 200);
        CHECK(near + far == 32 * 24);  // none between
      }
  });
}

TEST_CASE("A stencil buffer is multisampled too") {
  on_every_context([](Gl& gl) {
    for (const DepthFormat format : {DepthFormat::depth24_stencil8, DepthFormat::depth32f_stencil8}) {
      const Target target(gl, {.width = 32, .height = 24, .depth = format, .samples = 4});
      INFO(to_string(target.spec()));
      target.bind(gl);
      gl.ClearColor(0, 0, 0, 1);
      gl.ClearStencil(0);
      gl.Clear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
      gl.Enable(GL_STENCIL_TEST);
      gl.StencilFunc(GL_ALWAYS, 1, 0xff);
      gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
      draw_triangle(gl, slanted, 0, {0, 0, 0, 1});
      gl.StencilFunc(GL_EQUAL, 1, 0xff);
      gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
      draw_triangle(gl, everything, 0, {1, 1, 1, 1});
      gl.Disable(GL_STENCIL_TEST);
      const Image through_mask = target.read_colour(gl);
      gl.Clear(GL_COLOR_BUFFER_BIT);
      draw_triangle(gl, slanted, 0, {1, 1, 1, 1});
      CHECK(target.read_colour(gl) == through_mask);  // the mask's edge is cut sample by sample, as the triangle's is
    }
  });
}

TEST_CASE("A resolve covers every pixel and keeps the state") {
  on_every_context([](Gl& gl) {
    const Target target(gl, {.width = 8, .height = 8, .colour = ColourFormat::srgb8, .samples = 4}), other(gl, {});
    target.bind(gl);
    gl.ClearColor(1, 1, 1, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    other.bind(gl);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(0, 0, 1, 1);
    const GlRenderbuffer renderbuffer(gl);
    gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer.id());
    gl.BindTexture(GL_TEXTURE_2D, other.colour_texture());
    target.resolve(gl);
    CHECK(gl.IsEnabled(GL_SCISSOR_TEST));
    CHECK_FALSE(gl.IsEnabled(GL_FRAMEBUFFER_SRGB));
    CHECK(GLuint(integer_of(gl, GL_DRAW_FRAMEBUFFER_BINDING)) == other.framebuffer());
    CHECK(GLuint(integer_of(gl, GL_READ_FRAMEBUFFER_BINDING)) == other.framebuffer());
    CHECK(GLuint(integer_of(gl, GL_RENDERBUFFER_BINDING)) == renderbuffer.id());
    CHECK(GLuint(integer_of(gl, GL_TEXTURE_BINDING_2D)) == other.colour_texture());
    const Image picture = target.read_colour(gl);
    for (const Rgba& pixel : picture.pixels()) CHECK(pixel == Rgba{1, 1, 1, 1});
    gl.Disable(GL_SCISSOR_TEST);
  });
}

TEST_CASE("Depth is read back between 0 and 1, with row 0 on top") {
  struct Row {
    DepthFormat format;
    double tolerance;  ///< half a step of the format
  };
  const Row rows[] = {{DepthFormat::depth16, 0.5 / 65535},
                      {DepthFormat::depth24, 0.5 / 16777215 + 3e-8},  // plus half a float's step at 0.3
                      {DepthFormat::depth32f, 1.5e-8},                // 0.3 as a float
                      {DepthFormat::depth24_stencil8, 0.5 / 16777215 + 3e-8},
                      {DepthFormat::depth32f_stencil8, 1.5e-8}};
  on_every_context([&](Gl& gl) {
    for (const Row& row : rows)
      for (const ColourFormat colour : {ColourFormat::none, ColourFormat::rgba32f}) {
        const Target target(gl, {.width = 3, .height = 5, .colour = colour, .depth = row.format});
        INFO(to_string(target.spec()));
        target.bind(gl);
        gl.ClearDepth(1);
        gl.Clear(GL_DEPTH_BUFFER_BIT);
        gl.Enable(GL_SCISSOR_TEST);
        gl.Scissor(0, 4, 3, 1);  // the highest row
        gl.ClearDepth(0.3);
        gl.Clear(GL_DEPTH_BUFFER_BIT);
        gl.Disable(GL_SCISSOR_TEST);
        const Image image = target.read_depth(gl);
        for (int x = 0; x < 3; ++x) {
          CHECK(std::abs(double(image.at(x, 0).r) - 0.3) <= row.tolerance);
          CHECK(image.at(x, 0) == Rgba{image.at(x, 0).r, image.at(x, 0).r, image.at(x, 0).r, 1});
          for (int y = 1; y < 5; ++y) CHECK(image.at(x, y).r == 1);
        }
      }
  });
}

TEST_CASE("Impossible targets are refused with size and formats") {
  on_every_context([](Gl& gl) {
    for (const auto& [width, height] : {std::pair{0, 4}, {4, 0}, {-1, 4}, {16385, 1}, {1, 16385}, {1 << 30, 1 << 30}}) {
      const std::string size = std::to_string(width) + "x" + std::to_string(height);
      INFO(size);
      const TargetSpec spec{.width = width, .height = height};
      CHECK(mentions(error_of([&] { Target target(gl, spec); }), {size, "rgba32f", "depth24", "1..16384"}));
    }
    // Within the sides allowed, and 4 GB: llvmpipe ends at 1 GB a texture (on a GPU this may be possible).
    const TargetSpec vast{.width = 16384, .height = 16384, .depth = DepthFormat::none};
    if (mentions(gl.description(), {"llvmpipe"}))
      CHECK(mentions(error_of([&] { Target target(gl, vast); }), {"16384x16384", "rgba32f", "GL_OUT_OF_MEMORY"}));

    const int most = most_samples(gl);
    CHECK(most >= 4);  // OpenGL 3.3 promises them
    for (const int samples : {0, -1, most + 1}) {
      const TargetSpec spec{.width = 7, .height = 5, .samples = samples};
      CHECK(mentions(error_of([&] { Target target(gl, spec); }),
                     {"7x5", std::to_string(samples) + " samples", "1.." + std::to_string(most)}));
    }

    const TargetSpec nothing{.colour = ColourFormat::none, .depth = DepthFormat::none};
    CHECK(mentions(error_of([&] { Target target(gl, nothing); }), {"colour none", "depth none"}));

    const Target shadow(gl, {.colour = ColourFormat::none}), flat(gl, {.depth = DepthFormat::none});
    CHECK(mentions(error_of([&] { shadow.read_colour(gl); }), {"no colour"}));
    CHECK(mentions(error_of([&] { flat.read_depth(gl); }), {"no depth"}));
    CHECK(shadow.colour_texture() == 0);
    CHECK(flat.depth_texture() == 0);
  });
}

TEST_CASE("A target's bytes are counted as they are allocated") {
  const TargetSpec specs[] = {
      {.width = 3, .height = 5},
      {.colour = ColourFormat::none, .depth = DepthFormat::depth16},
      {.width = 640, .height = 480, .colour = ColourFormat::rgba16f, .depth = DepthFormat::none},
      {.colour = ColourFormat::rgba8, .depth = DepthFormat::depth32f_stencil8},
      {.width = 3, .height = 5, .colour = ColourFormat::srgb8, .samples = 4}};
  const std::size_t expected[] = {3 * 5 * 20, 2, 640 * 480 * 8, 12, 3 * 5 * 8 * (4 + 1)};
  on_every_context([&](Gl& gl) {
    for (int i = 0; i < 5; ++i) {
      INFO(to_string(specs[i]));
      gl.restart_counts();
      const Target target(gl, specs[i]);
      CHECK(bytes(specs[i]) == expected[i]);
      CHECK(std::size_t(gl.counts().allocated_bytes) == expected[i]);
    }
  });
}

TEST_CASE("A target moves with its contents") {
  on_every_context([](Gl& gl) {
    Target first(gl, {.width = 2, .height = 2});
    first.bind(gl);
    const Rgba value{3, 2, 1, 1};
    gl.ClearBufferfv(GL_COLOR, 0, &value.r);
    const Target second = std::move(first);
    CHECK(second.read_colour(gl).at(0, 1) == value);
  });
}
