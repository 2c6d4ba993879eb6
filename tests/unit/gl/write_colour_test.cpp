#include "gl/write_colour.hpp"

#include "catch.hpp"
#include "gl/context.hpp"

using namespace atelier;

TEST_CASE("a picture written into a target is read back unchanged", "[target]") {
  const auto context = make_headless_context();
  Image picture(3, 2);
  for (int i = 0; i < 6; ++i) picture.at(i % 3, i / 3) = {float(i) / 8, 0.25f, 1, 0.5f};
  const struct {
    ColourFormat format;
    double error;  ///< none; 2^-12 of numbers below 1; half a code, whose steps are 2.3/255 of light at most
  } rows[] = {{ColourFormat::rgba32f, 0}, {ColourFormat::rgba16f, 0.00025}, {ColourFormat::srgb8, 0.0046}};
  for (const auto& row : rows) {
    INFO(int(row.format));
    const Target target(context->gl(), {.width = 3, .height = 2, .colour = row.format, .depth = DepthFormat::none});
    write_colour(context->gl(), target, picture);
    const Image read = target.read_colour(context->gl());
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 3; ++x) {
        CHECK(std::abs(read.at(x, y).r - picture.at(x, y).r) <= row.error);
        CHECK(std::abs(read.at(x, y).g - 0.25f) <= row.error);
        CHECK(read.at(x, y).b == 1);
        CHECK(read.at(x, y).a == Approx(0.5).margin(0.002));  // 8 bits: half a 255th
      }
  }
}

TEST_CASE("a picture that does not fit a target is refused", "[target]") {
  const auto context = make_headless_context();
  Gl& gl = context->gl();
  const Target target(gl, {.width = 3, .height = 2}), samples(gl, {.width = 3, .height = 2, .samples = 4}),
      depth(gl, {.width = 3, .height = 2, .colour = ColourFormat::none});
  CHECK(mentions(error_of([&] { write_colour(gl, target, Image(2, 3)); }), {"3x2", "2x3"}));
  CHECK(mentions(error_of([&] { write_colour(gl, samples, Image(3, 2)); }), {"one sample"}));
  CHECK(mentions(error_of([&] { write_colour(gl, depth, Image(3, 2)); }), {"colour"}));
}
