// LDR-FLIP against a direct implementation of the paper: double precision, no separable filters, tiles or
// approximations.
#include "image/flip.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "catch.hpp"
#include "image/draw.hpp"
#include "pictures.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

struct Vec {
  double x = 0, y = 0, z = 0;
};

class Paper {
 public:
  Paper(const Image& encoded, double pixels_per_degree) : image_(encoded), ppd_(pixels_per_degree) {}

  /// Hunt-adjusted L*a*b* of the filtered picture (section 4.1).
  Lab colour(int px, int py) const {
    const int radius = int(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd_));
    Vec sum, weights;
    for (int dy = -radius; dy <= radius; ++dy)
      for (int dx = -radius; dx <= radius; ++dx) {
        const double d2 = (dx * dx + dy * dy) / (ppd_ * ppd_);
        const Vec w{gauss(d2, 1, 0.0047), gauss(d2, 1, 0.0053), gauss(d2, 34.1, 0.04) + gauss(d2, 13.5, 0.025)};
        const Vec c = opponent(px + dx, py + dy);
        sum = {sum.x + w.x * c.x, sum.y + w.y * c.y, sum.z + w.z * c.z};
        weights = {weights.x + w.x, weights.y + w.y, weights.z + w.z};
      }
    const double y = (sum.x / weights.x + 16) / 116, x = sum.y / weights.y / 500 + y, z = y - sum.z / weights.z / 200;
    Rgba rgb = xyz_to_linear({x * white_d65.x, y, z * white_d65.z});
    for (float* v : {&rgb.r, &rgb.g, &rgb.b}) *v = std::clamp(*v, 0.0f, 1.0f);
    const Lab lab = xyz_to_lab(linear_to_xyz(rgb));
    return {lab.l, 0.01 * lab.l * lab.a, 0.01 * lab.l * lab.b};
  }

  /// Strength of edges (order 1) or points (order 2) around a pixel (section 4.2).
  double feature(int px, int py, int order) const {
    const double s = 0.5 * 0.082 * ppd_;
    const int radius = int(std::ceil(3 * s));
    double along_x = 0, along_y = 0, positive = 0, negative = 0;
    for (int dy = -radius; dy <= radius; ++dy)
      for (int dx = -radius; dx <= radius; ++dx) {
        const double g = std::exp(-(dx * dx + dy * dy) / (2 * s * s));
        const auto weight = [&](int d) { return order == 1 ? -d * g : (d * d / (s * s) - 1) * g; };
        (weight(dx) > 0 ? positive : negative) += std::abs(weight(dx));
      }
    for (int dy = -radius; dy <= radius; ++dy)
      for (int dx = -radius; dx <= radius; ++dx) {
        const double g = std::exp(-(dx * dx + dy * dy) / (2 * s * s)), v = (opponent(px + dx, py + dy).x + 16) / 116;
        const auto weight = [&](int d) {
          const double w = order == 1 ? -d * g : (d * d / (s * s) - 1) * g;
          return w / (w > 0 ? positive : negative);
        };
        along_x += weight(dx) * v;
        along_y += weight(dy) * v;
      }
    return std::hypot(along_x, along_y);
  }

 private:
  static constexpr double pi = std::numbers::pi;
  static double gauss(double d2, double a, double b) { return a * std::sqrt(pi / b) * std::exp(-pi * pi * d2 / b); }

  /// Y Cx Cz of a pixel; the border repeats.
  Vec opponent(int x, int y) const {
    const Rgba& p = image_.at(std::clamp(x, 0, image_.width() - 1), std::clamp(y, 0, image_.height() - 1));
    const Xyz c = linear_to_xyz(srgb_decode(p));
    const double rx = c.x / white_d65.x, rz = c.z / white_d65.z;
    return {116 * c.y - 16, 500 * (rx - c.y), 200 * (c.y - rz)};
  }

  const Image& image_;
  double ppd_;
};

double distance(const Lab& p, const Lab& q) {
  return std::abs(p.l - q.l) + std::hypot(p.a - q.a, p.b - q.b);
}

/// The error in one pixel, step by step as in the paper.
double paper_error(const Image& reference, const Image& test, int x, int y, double ppd = 67.0206) {
  const Paper r(reference, ppd), t(test, ppd);
  const auto primary = [](Rgba c) {
    const Lab lab = xyz_to_lab(linear_to_xyz(c));
    return Lab{lab.l, 0.01 * lab.l * lab.a, 0.01 * lab.l * lab.b};
  };
  const double largest = std::pow(distance(primary({0, 1, 0}), primary({0, 0, 1})), 0.7), bend = 0.4 * largest;
  double colour = std::pow(distance(r.colour(x, y), t.colour(x, y)), 0.7);
  colour = colour < bend ? 0.95 / bend * colour : 0.95 + (colour - bend) / (largest - bend) * 0.05;
  const double change =
      std::max(std::abs(r.feature(x, y, 1) - t.feature(x, y, 1)), std::abs(r.feature(x, y, 2) - t.feature(x, y, 2)));
  return std::pow(colour, 1 - std::sqrt(change / std::numbers::sqrt2));
}

/// waves, with the marks that FLIP is about: a line, dots, noise, another tint.
Image marked(int width, int height) {
  Image image = waves(width, height, 0.4, 0);
  Noise noise(11);
  for (Rgba& p : image.pixels()) p.g += 0.1f * (noise.next() - 0.5f);
  for (int y = 0; y < height; ++y) image.at(width / 3, y) = {0, 0, 0, 1};
  for (int y = 5; y < height; y += 13)
    for (int x = 4; x < width; x += 11) image.at(x, y) = {1, 1, 0.2f, 1};
  return image;
}

// The map is made in floats with functions good to 1e-6; the power of 0.7 is steep near zero and makes 1e-5 of that.
constexpr double float_margin = 3e-5;

}  // namespace

TEST_CASE("FLIP equals the paper in every pixel of a small picture") {
  const Image reference = waves(37, 29), test = marked(37, 29);
  const Flip result = flip(reference, test);
  double worst = 0, sum = 0;
  for (int y = 0; y < 29; ++y)
    for (int x = 0; x < 37; ++x) {
      const double truth = paper_error(reference, test, x, y);
      worst = std::max(worst, std::abs(result.map.at(x, y).r - truth));
      sum += truth;
    }
  CHECK(worst < float_margin);
  CHECK(result.mean == Approx(sum / (37 * 29)).margin(float_margin));
  CHECK(result.mean > 0.05);  // there was something to see
}

TEST_CASE("FLIP at other distances from the screen") {
  const Image reference = waves(20, 12), test = marked(20, 12);
  for (double ppd : {1.0, 20.0, 45.5, 200.0}) {
    const Flip result = flip(reference, test, {.pixels_per_degree = ppd});
    for (int x : {0, 7, 19})
      CHECK(result.map.at(x, 6).r == Approx(paper_error(reference, test, x, 6, ppd)).margin(float_margin));
  }
}

TEST_CASE("FLIP: results do not depend on tiles or threads") {
  const Image reference = waves(500, 300), test = marked(500, 300);
  const Flip one = flip(reference, test), three = flip(reference, test, {.threads = 3});
  CHECK(one.map == three.map);
  CHECK(one.mean == three.mean);
  for (int y : {0, 270, 299})
    for (int x : {0, 480, 499}) {
      INFO(x << ", " << y);
      CHECK(one.map.at(x, y).r == Approx(paper_error(reference, test, x, y)).margin(float_margin));
    }
  // Around the place where four tiles meet, the same pixels within one tile: equal to the last bit, but for the margin
  // of ten pixels where the crop's border is seen.
  const Box box{440, 230, 60, 70};
  const Flip part = flip(crop(reference, box), crop(test, box));
  int different = 0;
  for (int y = 10; y < box.height - 10; ++y)
    for (int x = 10; x < box.width - 10; ++x) different += part.map.at(x, y) != one.map.at(box.x + x, box.y + y);
  CHECK(different == 0);
}

TEST_CASE("FLIP of plain colours") {
  struct Row {
    const char* name;
    Rgba reference, test;
    double error;
  };
  // Black and white: 100^0.7 = 25.119 lies past the bend at 0.4 x 41.276; green and blue are the furthest apart.
  for (const Row& row : {Row{"equal", {0.3f, 0.6f, 0.1f}, {0.3f, 0.6f, 0.1f}, 0},
                         {"black, white", {0, 0, 0}, {1, 1, 1}, 0.967381},
                         {"green, blue", {0, 1, 0}, {0, 0, 1}, 1},
                         {"clamped", {0, 0, 0}, {7, 3, 1}, 0.967381}}) {
    INFO(row.name);
    const Flip result = flip(Image(30, 20, row.reference), Image(30, 20, row.test));
    CHECK(result.mean == Approx(row.error).margin(float_margin));
    CHECK(result.map.at(3, 3).r == Approx(row.error).margin(float_margin));
  }
}

TEST_CASE("FLIP: equal pictures are exactly equal, linear ones are not decoded, NaN is black") {
  const Image picture = marked(60, 40);
  CHECK(flip(picture, picture).mean == 0);
  const Image other = waves(60, 40);
  const Flip encoded = flip(other, picture);
  const Flip linear = flip(srgb_decode(other), srgb_decode(picture), {.encoding = Encoding::linear});
  CHECK(linear.mean == Approx(encoded.mean).margin(float_margin));
  Image hurt = Image(9, 9, {0, 0, 0, 1});
  hurt.at(4, 4).r = std::numeric_limits<float>::quiet_NaN();
  CHECK(flip(Image(9, 9, {0, 0, 0, 1}), hurt).mean == 0);
  CHECK(flip(Image(1, 1, {0, 0, 0, 1}), Image(1, 1, {1, 1, 1, 1})).mean == Approx(0.967381).margin(float_margin));
}

TEST_CASE("FLIP refuses what it cannot compare") {
  const Image a(4, 4), b(5, 4);
  CHECK(mentions(error_of([&] { flip(a, b); }), {"4 x 4", "5 x 4"}));
  CHECK_FALSE(error_of([&] { flip(Image(), Image()); }).empty());
  CHECK(mentions(error_of([&] { flip(a, a, {.encoding = Encoding::data}); }), {"encoding"}));
  for (double ppd : {0.0, -1.0, 201.0, std::numeric_limits<double>::quiet_NaN()})
    CHECK(mentions(error_of([&] { flip(a, a, {.pixels_per_degree = ppd}); }), {"per degree", "1 to 200"}));
  for (int threads : {0, -1, 65})
    CHECK(mentions(error_of([&] { flip(a, a, {.threads = threads}); }), {"threads", "1 to 64"}));
}
