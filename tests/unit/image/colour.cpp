// The sRGB curve, XYZ and L*a*b* against published figures, and the fast versions against the exact ones.
#include "image/colour.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"
#include "image/fast_math.hpp"

using namespace atelier;

TEST_CASE("sRGB: published pairs of linear and encoded values") {
  struct Row {
    double linear, encoded;
  };
  // IEC 61966-2-1: the ends, the knee, and middle grey (encoded 0.5 is 21.4 % of the light).
  for (const Row& row :
       {Row{0, 0}, {1, 1}, {0.0031308, 0.04045}, {0.21404114, 0.5}, {0.001, 0.01292}, {0.5, 0.73535698}}) {
    // The standard gives its knee to five digits, so the two sides of it miss each other by 1e-6 or less.
    CHECK(srgb_encode(row.linear) == Approx(row.encoded).margin(1e-6));
    CHECK(srgb_decode(row.encoded) == Approx(row.linear).margin(1e-6));
    CHECK(srgb_encode(float(row.linear)) == Approx(row.encoded).margin(1e-6));
    CHECK(srgb_decode(float(row.encoded)) == Approx(row.linear).margin(1e-6));
  }
}

TEST_CASE("sRGB: all 8-bit codes survive decoding and encoding") {
  for (int code = 0; code < 256; ++code) CHECK(std::lround(srgb_encode(srgb_decode(float(code) / 255)) * 255) == code);
  for (int code = 0; code < 256; ++code) CHECK(srgb_code(srgb_decode(float(code) / 255)) == code);
  for (int code = 0; code < 256; ++code) CHECK(linear_of_code(std::uint8_t(code)) == float(srgb_decode(code / 255.0)));
  for (int step = 0; step <= 1000; ++step)
    CHECK(srgb_code(float(step) / 1000) == std::lround(srgb_encode(double(float(step) / 1000)) * 255));
  CHECK(srgb_code(-1.0f) == 0);
  CHECK(srgb_code(7.0f) == 255);
  CHECK(srgb_code(std::numeric_limits<float>::infinity()) == 255);
  CHECK(srgb_code(std::numeric_limits<float>::quiet_NaN()) == 0);
}

TEST_CASE("sRGB: values outside 0..1 are not clamped") {
  constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(srgb_encode(-0.5f) == Approx(-6.46f));
  CHECK(srgb_decode(-6.46f) == Approx(-0.5f));
  CHECK(srgb_encode(4.0f) == Approx(1.055 * std::pow(4.0, 1 / 2.4) - 0.055));
  CHECK(srgb_encode(inf) == inf);
  CHECK(srgb_encode(-inf) == -inf);
  CHECK(std::isnan(srgb_encode(nan)));
  CHECK(std::isnan(srgb_decode(nan)));
  CHECK(srgb_encode(Rgba{1, 0, 1, 0.25f}) == Rgba{1, 0, 1, 0.25f});
}

TEST_CASE("XYZ and L*a*b* of the primaries") {
  struct Row {
    const char* name;
    Rgba linear;
    double y, l, a, b;
  };
  // BT.709's luminances; L*a*b* of sRGB's primaries under D65 as colour tables print them, to two digits.
  for (const Row& row :
       {Row{"white", {1, 1, 1}, 1, 100, 0, 0}, Row{"black", {0, 0, 0}, 0, 0, 0, 0},
        Row{"red", {1, 0, 0}, 0.2126, 53.24, 80.09, 67.20}, Row{"green", {0, 1, 0}, 0.7152, 87.73, -86.18, 83.18},
        Row{"blue", {0, 0, 1}, 0.0722, 32.30, 79.19, -107.86}}) {
    INFO(row.name);
    const Xyz xyz = linear_to_xyz(row.linear);
    const Lab lab = xyz_to_lab(xyz);
    CHECK(xyz.y == Approx(row.y).margin(5e-5));  // the table has four digits
    CHECK(luminance(row.linear) == Approx(row.y).margin(5e-5));
    CHECK(lab.l == Approx(row.l).margin(0.02));  // tables differ by 0.01 in which white they take
    CHECK(lab.a == Approx(row.a).margin(0.02));
    CHECK(lab.b == Approx(row.b).margin(0.02));
    const Rgba back = xyz_to_linear(xyz);
    CHECK(back.r == Approx(row.linear.r).margin(1e-6));  // a few roundings of a float
    CHECK(back.g == Approx(row.linear.g).margin(1e-6));
    CHECK(back.b == Approx(row.linear.b).margin(1e-6));
  }
}

namespace {

/// The largest error of `fast` against `exact`, over x from `low` to `high` in steps of a constant factor.
template <class Fast, class Exact>
double largest_error(double low, double high, bool relative, Fast fast, Exact exact) {
  double largest = 0;
  for (double x = low; x <= high; x *= 1.0005) {
    const double truth = exact(double(float(x)));
    const double error = std::abs(double(fast(float(x))) - truth) / (relative ? std::abs(truth) : 1);
    largest = error > largest ? error : largest;
  }
  return largest;
}

}  // namespace

TEST_CASE("fast functions keep their documented error bounds") {
  const auto exact_log2 = [](double x) { return std::log2(x); };
  const auto exact_exp2 = [](double x) { return std::exp2(x); };
  const auto exact_cbrt = [](double x) { return std::cbrt(x); };
  CHECK(largest_error(std::exp2(-20), 16, false, fast::log2, exact_log2) < 1.1e-6);
  CHECK(largest_error(1e-3, 126, true, fast::exp2, exact_exp2) < 3e-7);
  CHECK(largest_error(
            1e-3, 126, true, [](float x) { return fast::exp2(-x); }, [](double x) { return std::exp2(-x); }) < 3e-7);
  CHECK(largest_error(std::exp2(-64), std::exp2(64), true, fast::cbrt, exact_cbrt) < 3e-7);
  double encode = 0, decode = 0;
  for (int i = 0; i <= 100'000; ++i) {
    const float x = float(i) / 100'000;
    encode = std::max(encode, std::abs(fast::srgb_encode(x) - srgb_encode(double(x))));
    decode = std::max(decode, std::abs(fast::srgb_decode(x) - srgb_decode(double(x))));
  }
  CHECK(encode < 1e-6);
  CHECK(decode < 1e-6);
  CHECK(fast::clamp01(std::numeric_limits<float>::quiet_NaN()) == 0);
  CHECK(fast::clamp01(std::numeric_limits<float>::infinity()) == 1);
  CHECK(fast::clamp01(-1) == 0);
}
