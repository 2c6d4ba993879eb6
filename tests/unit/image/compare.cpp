// The parts of a comparison, each on pictures with an obvious result.
#include "image/compare.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "catch.hpp"
#include "image/colour.hpp"
#include "pictures.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity(),
                not_a_number = std::numeric_limits<float>::quiet_NaN();

void fill(Image& image, int x0, int y0, int width, int height, Rgba colour) {
  for (int y = y0; y < y0 + height; ++y)
    for (int x = x0; x < x0 + width; ++x) image.at(x, y) = colour;
}

/// A direction `degrees` away from +z towards +x, of some length, as n/2 + 1/2.
Rgba direction(double degrees, double length = 1) {
  const double a = degrees * std::numbers::pi / 180;
  return {float(0.5 + 0.5 * length * std::sin(a)), 0.5f, float(0.5 + 0.5 * length * std::cos(a)), 1};
}

}  // namespace

TEST_CASE("a picture's width and height are 1 to 16384") {
  for (auto [width, height] : {std::pair{0, 1}, {1, 0}, {-5, 5}, {16385, 1}, {1, 16385}}) {
    CHECK(mentions(error_of([&, w = width, h = height] { Image(w, h); }), {std::to_string(width), "16384"}));
    CHECK(mentions(error_of([&, w = width, h = height] { Mask(w, h); }), {std::to_string(height), "16384"}));
  }
  CHECK(Image(16384, 1).width() == 16384);
  CHECK(Image().empty());
}

TEST_CASE("non-finite pixels are counted, and the first ten named") {
  Image image = waves(40, 30);
  CHECK(find_non_finite(image).count == 0);
  image.at(3, 1) = {std::numeric_limits<float>::max(), -std::numeric_limits<float>::max(), 1e-45f, 1};
  CHECK(find_non_finite(image).count == 0);
  image.at(7, 2).g = not_a_number;
  image.at(5, 2).r = -infinite;
  image.at(0, 9).a = infinite;
  const NonFinite three = find_non_finite(image);
  CHECK(three.count == 3);
  CHECK(three.first == std::vector<Position>{{5, 2}, {7, 2}, {0, 9}});
  fill(image, 0, 20, 40, 10, {not_a_number, not_a_number, not_a_number, not_a_number});
  CHECK(find_non_finite(image).count == 403);
  CHECK(find_non_finite(image).first.size() == 10);
}

TEST_CASE("single colour") {
  Image image(8, 8, {0.2f, 0.4f, 0.6f, 1});
  image.at(7, 7).a = 0;  // opacity is not looked at
  CHECK(is_single_colour(image));
  image.at(7, 7).b = 0.601f;
  CHECK_FALSE(is_single_colour(image));
  CHECK(is_single_colour(image, 0.01f));
  image.at(7, 7).b = not_a_number;
  CHECK_FALSE(is_single_colour(image, 0.01f));
  CHECK(is_single_colour(Image(1, 1)));
}

TEST_CASE("encoding for comparison: exposed, clamped, within 1e-6 of the exact curve") {
  Image image(301, 3);  // no multiple of any block
  for (int i = 0; i < 903; ++i) image.pixels()[std::size_t(i)] = {float(i) / 900, float(i) / 300, -0.1f, 1};
  image.at(4, 0) = {not_a_number, infinite, -infinite, not_a_number};
  const Image encoded = encode_for_comparison(image, 0.5f);
  CHECK(encoded.at(4, 0).r == 0);
  CHECK(encoded.at(4, 0).g == Approx(1).margin(1e-6));
  CHECK(encoded.at(4, 0).b == 0);
  CHECK(encoded.at(4, 0).a == 0);
  double worst = 0;
  for (std::size_t i = 5; i < 903; ++i) {
    const auto exact = [&](float v) { return srgb_encode(std::min(double(v) * 0.5, 1.0)); };
    worst = std::max({worst, std::abs(encoded.pixels()[i].r - exact(image.pixels()[i].r)),
                      std::abs(encoded.pixels()[i].g - exact(image.pixels()[i].g))});
    CHECK(encoded.pixels()[i].b == 0);
  }
  CHECK(worst < 1e-6);
}

TEST_CASE("erosion keeps pixels that are surrounded on all sides") {
  struct Row {
    const char* name;
    int x, y, width, height, left;
  };
  for (const Row& row : {Row{"a pixel", 5, 5, 1, 1, 0},
                         {"2 x 20", 3, 2, 2, 20, 0},
                         {"3 x 3", 9, 9, 3, 3, 1},
                         {"5 x 4", 9, 9, 5, 4, 6},
                         {"3 x 3 in a corner", 0, 0, 3, 3, 1},
                         {"2 x 2 in a corner", 0, 0, 2, 2, 0},
                         {"all", 0, 0, 30, 30, 28 * 28}}) {
    INFO(row.name);
    Mask mask(30, 30);
    for (int y = row.y; y < row.y + row.height; ++y)
      for (int x = row.x; x < row.x + row.width; ++x) mask.set(x, y, true);
    CHECK(mask.count() == row.width * row.height);
    CHECK(erode(mask).count() == row.left);
  }
  CHECK(erode(Mask(2, 9)) == Mask(2, 9));
}

TEST_CASE("strict: pixels over delta, solid ones, and the worst") {
  struct Row {
    const char* name;
    int x, y, width, height;
    float change;  // of green, in levels
    int over, blob;
  };
  // Changes stay a tenth of a level off the tolerance of 3, except the row that sits on it on purpose.
  for (const Row& row : {Row{"nothing", 0, 0, 1, 1, 0, 0, 0},
                         {"just within", 4, 4, 9, 9, 2.9f, 0, 0},
                         {"exactly three levels", 4, 4, 9, 9, 3, 0, 0},
                         {"just over", 4, 4, 9, 9, -3.1f, 81, 49},
                         {"a line", 2, 7, 60, 1, 40, 60, 0},
                         {"a thick line", 2, 7, 60, 3, 40, 180, 58},
                         {"the last pixel", 63, 47, 1, 1, -90, 1, 0}}) {
    INFO(row.name);
    const Image reference(64, 48, {0.4f, 100 / 255.0f, 0.7f, 1});
    Image yours = reference;
    fill(yours, row.x, row.y, row.width, row.height, {0.4f, (100 + row.change) / 255, 0.7f, 0.3f});
    const Difference d = compare_strict(yours, reference, Measure::level, 3);
    CHECK(d.over == row.over);
    CHECK(d.mask.count() == row.over);
    CHECK(d.blob == row.blob);
    CHECK(d.share == Approx(row.over / (64.0 * 48)));
    CHECK(d.worst_distance == Approx(std::abs(row.change)).margin(1e-4));  // rounding of 100/255 in a float, times 255
    if (row.change != 0) CHECK(d.worst == Position{row.x, row.y});
  }
}

TEST_CASE("strict: eight-bit codes exactly delta apart are within it, however their floats round") {
  const Image reference = grey(253, 1, [](int x, int) { return x / 255.0; });
  CHECK(compare_strict(grey(253, 1, [](int x, int) { return (x + 3) / 255.0; }), reference, Measure::level, 3).over ==
        0);
  CHECK(compare_strict(grey(252, 1, [](int x, int) { return (x + 4) / 255.0; }),
                       grey(252, 1, [](int x, int) { return x / 255.0; }), Measure::level, 3)
            .over == 252);
}

TEST_CASE("strict: honest noise of one level passes, and each channel counts by itself") {
  Noise noise(7);
  const Image reference = waves(64, 64);
  Image yours = reference;
  for (Rgba& p : yours.pixels()) p.r += (noise.next() - 0.5f) * 2 / 255, p.b -= (noise.next() - 0.5f) * 2 / 255;
  CHECK(compare_strict(yours, reference, Measure::level, 3).over == 0);
  for (float Rgba::*channel : {&Rgba::r, &Rgba::g, &Rgba::b}) {
    yours = reference;
    yours.at(9, 9).*channel += 0.1f;
    const Difference d = compare_strict(yours, reference, Measure::level, 3);
    CHECK(d.over == 1);
    CHECK(d.worst == Position{9, 9});
  }
}

TEST_CASE("NaN in either picture is over delta") {
  for (Measure measure : {Measure::level, Measure::degrees, Measure::number})
    for (float bad : {not_a_number, infinite, -infinite})
      for (float Rgba::*channel : {&Rgba::r, &Rgba::g, &Rgba::b}) {
        const Image reference = waves(12, 12);
        Image yours = reference;
        yours.at(3, 5).*channel = bad;
        for (const Difference& d :
             {compare_strict(yours, reference, measure, 170), compare_strict(reference, yours, measure, 170),
              compare_robust(yours, reference, measure, 170)}) {
          CHECK(d.over == 1);
          CHECK(d.worst == Position{3, 5});
          CHECK(std::isinf(d.worst_distance));
        }
      }
}

TEST_CASE("degrees: the angle between coded directions of any length") {
  struct Row {
    const char* name;
    Rgba yours, reference;
    double degrees;
  };
  const Rgba zero{0.5f, 0.5f, 0.5f, 1}, zero_in_eight_bits{128 / 255.0f, 127 / 255.0f, 128 / 255.0f, 1};
  for (const Row& row : {Row{"same", direction(10), direction(10), 0},
                         {"small", direction(0.5), direction(0), 0.5},
                         {"right angle", direction(90), direction(0), 90},
                         {"opposite", direction(180), direction(0), 180},
                         {"another length", direction(30, 0.3), direction(30, 2), 0},
                         {"both zero", zero, zero_in_eight_bits, 0},
                         {"one zero", zero, direction(45), 180}}) {
    INFO(row.name);
    const Difference d =
        compare_strict(Image(2, 2, row.yours), Image(2, 2, row.reference), Measure::degrees, row.degrees + 0.1);
    // 0.02: a chord from floats of 6e-8 near 1 is that exact; near 180 degrees its square root shows.
    CHECK(d.worst_distance == Approx(row.degrees).margin(0.02));
    CHECK(d.over == 0);
    // Near 180 degrees a chord hardly grows with its angle: half a degree is lost in a float's rounding.
    const double less = row.degrees - (row.degrees > 170 ? 1 : 0.1);
    if (less > 0)
      CHECK(compare_strict(Image(2, 2, row.yours), Image(2, 2, row.reference), Measure::degrees, less).over == 4);
  }
}

TEST_CASE("numbers: differences in the data's own unit") {
  const Image reference(3, 3, {1000, -5, 0, 1});
  Image yours(3, 3, {1000.5f, -5, 0, 1});
  CHECK(compare_strict(yours, reference, Measure::number, 0.5).over == 0);
  CHECK(compare_strict(yours, reference, Measure::number, 0.49).over == 9);
  CHECK(compare_strict(reference, reference, Measure::number, 0).over == 0);
  yours = reference;
  yours.at(1, 1).b = 1e-30f;
  CHECK(compare_strict(yours, reference, Measure::number, 0).over == 1);
}

TEST_CASE("robust: an edge may move by a pixel, a hole is an error") {
  const auto edge = [](int at) { return grey(40, 40, [=](int x, int) { return x < at ? 0.2 : 0.8; }); };
  const Image reference = edge(20);
  CHECK(compare_strict(edge(21), reference, Measure::level, 3).over == 40);
  CHECK(compare_robust(edge(21), reference, Measure::level, 3).over == 0);
  CHECK(compare_robust(edge(22), reference, Measure::level, 3).over == 40);
  Image hole = reference;
  fill(hole, 5, 5, 5, 5, {0.5f, 0.5f, 0.5f, 1});
  const Difference d = compare_robust(hole, reference, Measure::level, 3);
  CHECK(d.over == 25);
  CHECK(d.blob == 9);
  CHECK(d.worst_distance == Approx(0.3 * 255).margin(1e-3));  // float rounding of 0.5 - 0.2, times 255

  Image turned(20, 20, direction(0));
  fill(turned, 10, 0, 10, 20, direction(40));
  Image moved(20, 20, direction(0));
  fill(moved, 11, 0, 9, 20, direction(40));
  CHECK(compare_strict(moved, turned, Measure::degrees, 1).over == 20);
  CHECK(compare_robust(moved, turned, Measure::degrees, 1).over == 0);
}

TEST_CASE("pictures that cannot be compared are refused") {
  const Image a(4, 4), b(4, 5);
  for (auto compare : {compare_strict, compare_robust}) {
    CHECK(mentions(error_of([&] { compare(a, b, Measure::level, 3); }), {"4 x 4", "4 x 5"}));
    CHECK_FALSE(error_of([&] { compare(Image(), Image(), Measure::level, 3); }).empty());
    CHECK(mentions(error_of([&] { compare(a, a, Measure::level, -1); }), {"-1"}));
    CHECK_FALSE(error_of([&] { compare(a, a, Measure::level, not_a_number); }).empty());
  }
  CHECK_FALSE(error_of([&] { fit_shift(a, b); }).empty());
}

TEST_CASE("shift: fitted below a pixel") {
  struct Row {
    double x, y;
  };
  for (const Row& row : {Row{0, 0}, {0.05, 0}, {0, -0.05}, {0.3, -0.2}, {-0.5, 0.5}, {1, 0}}) {
    const Shift s = fit_shift(waves(96, 80, row.x, row.y), waves(96, 80));
    // Central differences flatten the gradient of these waves by sin(0.23)/0.23, under 1 %; the step is good to its
    // tenth.
    const double margin = 0.002 + 0.1 * std::hypot(row.x, row.y);
    CHECK(s.x == Approx(row.x).margin(margin));
    CHECK(s.y == Approx(row.y).margin(margin));
  }
}

TEST_CASE("shift: edges, noise, stripes and nothing at all") {
  const auto disc = [](double cx) {  // anti-aliased over one pixel, as a renderer's edges are
    return grey(64, 64, [=](int x, int y) { return std::clamp(20.5 - std::hypot(x - cx, y - 32.0), 0.0, 1.0); });
  };
  // One step over edges as sharp as a pixel overshoots by up to a third.
  CHECK(fit_shift(disc(32.3), disc(32)).x == Approx(0.3).margin(0.1));
  CHECK(fit_shift(disc(32.3), disc(32)).y == Approx(0).margin(0.01));  // symmetric

  Noise noise(3);
  Image noisy = waves(96, 80);
  for (Rgba& p : noisy.pixels()) p.r += (noise.next() - 0.5f) * 2 / 255, p.g += (noise.next() - 0.5f) * 2 / 255;
  CHECK(fit_shift(noisy, waves(96, 80)).length() < 0.01);  // a fifth of what a verdict calls moved

  const Image flat(32, 32, {0.5f, 0.5f, 0.5f, 1});
  CHECK(fit_shift(flat, flat).length() == 0);
  Image brighter(32, 32, {0.6f, 0.6f, 0.6f, 1});
  CHECK(fit_shift(brighter, flat).length() == 0);

  const auto stripes = [](double dx) {
    return grey(64, 64, [=](int x, int) { return 0.5 + 0.4 * std::sin(0.3 * (x - dx)); });
  };
  const Shift s = fit_shift(stripes(0.2), stripes(0));
  CHECK(s.x == Approx(0.2).margin(0.02));
  CHECK(std::abs(s.y) < 1e-9);

  Image hurt = waves(96, 80, 0.3, 0);
  hurt.at(40, 40) = {not_a_number, infinite, 0, 1};
  CHECK(fit_shift(hurt, waves(96, 80)).x == Approx(0.3).margin(0.03));
  CHECK(fit_shift(Image(2, 2), Image(2, 2)).length() == 0);
}
