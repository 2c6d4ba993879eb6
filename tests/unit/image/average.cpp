#include "image/average.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;

namespace {

/// A picture whose pixels all differ.
Image numbered(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.at(x, y) = {float(x), float(y), float(x * y), float(x) / float(width)};
  return image;
}

}  // namespace

TEST_CASE("each pixel is the mean of its block", "[average]") {
  const Image small = averaged(numbered(6, 9), 3, Encoding::linear);
  REQUIRE(small.width() == 2);
  REQUIRE(small.height() == 3);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 2; ++x) {
      // Over 3 x 3 pixels x, y and (where one does not depend on the other) x y have the middle one's value.
      const int cx = 3 * x + 1, cy = 3 * y + 1;
      CHECK(small.at(x, y) == Rgba{float(cx), float(cy), float(cx * cy), float(cx / 6.0)});
    }
  CHECK(averaged(numbered(5, 7), 1, Encoding::linear) == numbered(5, 7));
}

TEST_CASE("equal pixels stay unchanged, to the bit", "[average]") {
  for (const float value : {0.1f, 0.3f, 1e-30f, -7.7f, 3e38f}) {
    INFO(value);
    const Image even(12, 12, {value, value, value, value});
    for (const int factor : {2, 3, 4}) CHECK(averaged(even, factor, Encoding::linear).at(1, 1) == even.at(0, 0));
  }
}

TEST_CASE("sRGB codes are averaged in linear light", "[average]") {
  Image checks(2, 2, {1, 1, 1, 1});
  checks.at(0, 0) = checks.at(1, 1) = {0, 0, 0, 0};
  CHECK(averaged(checks, 2, Encoding::linear).at(0, 0) == Rgba{0.5f, 0.5f, 0.5f, 0.5f});
  const Rgba code = averaged(checks, 2, Encoding::srgb).at(0, 0);
  CHECK(code.r == srgb_encode(0.5f));  // 0.735: as bright as the checks are from afar
  CHECK(code.a == 0.5f);               // opacity is no light
}

TEST_CASE("NaN and infinity stay in the mean", "[average]") {
  for (const Encoding encoding : {Encoding::linear, Encoding::srgb}) {
    Image image(4, 2);
    image.at(0, 1).g = std::numeric_limits<float>::quiet_NaN();
    image.at(2, 0).b = std::numeric_limits<float>::infinity();
    const Image mean = averaged(image, 2, encoding);
    CHECK(std::isnan(mean.at(0, 0).g));
    CHECK(mean.at(0, 0).r == 0);
    CHECK(std::isinf(mean.at(1, 0).b));
  }
}

TEST_CASE("invalid sizes, and data, are refused", "[average]") {
  CHECK(mentions(error_of([] { averaged(Image(6, 4), 4, Encoding::linear); }), {"6 x 4", "4 x 4"}));
  CHECK(mentions(error_of([] { averaged(Image(4, 6), 4, Encoding::linear); }), {"4 x 6", "4 x 4"}));
  CHECK(mentions(error_of([] { averaged(Image(4, 4), 0, Encoding::linear); }), {"4 x 4", "0 x 0"}));
  CHECK(mentions(error_of([] { averaged(Image(4, 4), 2, Encoding::data); }), {"data"}));
}
