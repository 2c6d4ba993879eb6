// The error of a picture against its truth, on pictures whose error is known.
#include "image/error.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"

namespace atelier {
namespace {

Image filled(Rgba colour) {
  return Image(16, 12, colour);
}

/// Brightness that rises by 0.01 a pixel to the right, seen `shift` pixels further to the right.
Image ramp(double shift) {
  Image image(64, 48);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      const float value = float(0.1 + 0.01 * (x - shift));
      image.at(x, y) = {value, value, value, 1};
    }
  return image;
}

/// Rows that are lit, but for those from `first` to just before `last`, which are in shadow.
Image factors(int first, int last) {
  Image image = filled({1, 1, 1, 1});
  for (int y = first; y < last; ++y)
    for (int x = 0; x < image.width(); ++x) image.at(x, y) = {0, 0, 0, 1};
  return image;
}

Image direction(double degrees) {
  const double angle = degrees * 3.14159265358979 / 180;
  return filled({float(std::sin(angle) / 2 + 0.5), 0.5f, float(std::cos(angle) / 2 + 0.5), 1});
}

/// Black and white pixels in turn.
Image checkers() {
  Image image(16, 12);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const float grey = (x + y) % 2 == 0 ? 0.0f : 1.0f;
      image.at(x, y) = {grey, grey, grey, 1};
    }
  return image;
}

}  // namespace

TEST_CASE("known distances") {
  Image stain = filled({0.5f, 0.5f, 0.5f, 1});
  for (int x = 0; x < 16; ++x) stain.at(x, 3) = {0.5f, 0.8f, 0.5f, 1};
  struct Row {
    const char* name;
    Image picture, truth;
    ErrorMetric metric;
    double error, margin;
  };
  const Image grey = filled({0.5f, 0.5f, 0.5f, 1});
  const double of_floats = 1e-6;  // pictures hold floats of about 1
  const std::vector<Row> rows = {
      {"rmse of one channel in three", filled({0.8f, 0.5f, 0.5f, 1}), grey, ErrorMetric::rmse, 0.3 / std::sqrt(3),
       of_floats},
      {"distance of positions", filled({1, 2, 2, 1}), filled({0, 0, 0, 1}), ErrorMetric::distance, 3, of_floats},
      {"one row of twelve", stain, grey, ErrorMetric::misclassified, 1.0 / 12, of_floats},
      {"what is hardly seen is no error", filled({0.502f, 0.5f, 0.5f, 1}), grey, ErrorMetric::misclassified, 0, 0},
      {"degrees", direction(30), direction(10), ErrorMetric::degrees, 20, 1e-4},
      {"a small angle keeps its digits", direction(0.01), direction(0), ErrorMetric::degrees, 0.01, 1e-5},
      {"moved by a third of a pixel", ramp(1.0 / 3), ramp(0), ErrorMetric::displacement, 1.0 / 3, 1e-4},
      {"nothing to tell a movement by", filled({0.7f, 0, 0, 1}), grey, ErrorMetric::displacement, 0, 0},
      {"a third is in shadow that ought to be lit", factors(0, 8), factors(4, 8), ErrorMetric::acne, 4.0 / 12, 0},
      {"and no light leaks there", factors(0, 8), factors(4, 8), ErrorMetric::leak, 0, 0},
      {"light leaks", factors(4, 8), factors(4, 11), ErrorMetric::leak, 3.0 / 12, 0},
      {"and nothing is too dark", factors(4, 8), factors(4, 11), ErrorMetric::acne, 0, 0},
      {"of zeros and ones, both together", factors(1, 7), factors(3, 12), ErrorMetric::wrong, 7.0 / 12, 0},
      {"wrong by half is not acne", grey, filled({1, 0, 0, 1}), ErrorMetric::acne, 0, 0},
      {"nor a leak", grey, filled({0, 0, 0, 1}), ErrorMetric::leak, 0, 0},
      {"a half counts as lit", grey, filled({1, 0, 0, 1}), ErrorMetric::wrong, 0, 0},
      {"just off the other side", filled({0.499f, 0, 0, 1}), grey, ErrorMetric::wrong, 1, 0},
      {"only red counts", filled({1, 0, 0, 1}), filled({1, 1, 1, 1}), ErrorMetric::wrong, 0, 0},
      {"a blur keeps what is even", filled({0.8f, 0.5f, 0.5f, 1}), grey, ErrorMetric::blurred_light,
       0.3 / std::sqrt(3), of_floats},
      {"black and white in turn are half of the light", checkers(), grey, ErrorMetric::blurred_light, 0, 0.01},
      {"and a fifth of it looks like half of the codes", checkers(), filled({0.21404f, 0.21404f, 0.21404f, 1}),
       ErrorMetric::blurred_codes, 0, 0.01},
      {"without a blur each pixel is wrong", checkers(), grey, ErrorMetric::rmse, 0.5, of_floats},
      {"the mean of a picture", filled({0, 0.5f, 1, 1}), Image(), ErrorMetric::mean, 0.5, of_floats},
      {"equal pictures: FLIP", stain, stain, ErrorMetric::flip, 0, 0},
      {"opacity is not looked at", filled({0.5f, 0.5f, 0.5f, 0}), grey, ErrorMetric::rmse, 0, 0},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    CHECK(error_of(row.picture, row.truth, row.metric) == Approx(row.error).margin(row.margin));
  }
}

TEST_CASE("an edge does not change the median") {
  Image picture = ramp(0.1), truth = ramp(0);
  for (int y = 0; y < 48; ++y) picture.at(40, y) = {9, 9, 9, 1};
  CHECK(error_of(picture, truth, ErrorMetric::displacement) == Approx(0.1).margin(1e-4));
}

TEST_CASE("pictures that cannot be compared are refused with the reason") {
  const Image grey = filled({0.5f, 0.5f, 0.5f, 1});
  Image broken = grey;
  broken.at(2, 5).g = std::numeric_limits<float>::quiet_NaN();
  using test::error_of;
  CHECK(
      test::mentions(error_of([&] { atelier::error_of(broken, grey, ErrorMetric::rmse); }), {"the picture", "(2, 5)"}));
  CHECK(test::mentions(error_of([&] { atelier::error_of(grey, broken, ErrorMetric::rmse); }), {"its truth", "(2, 5)"}));
  CHECK(test::mentions(error_of([&] { atelier::error_of(grey, Image(3, 3), ErrorMetric::rmse); }), {"16x12", "3x3"}));
  CHECK(test::mentions(error_of([&] { atelier::error_of(broken, grey, ErrorMetric::mean); }), {"the picture"}));
  CHECK(error_of([&] { atelier::error_of(grey, grey, ErrorMetric::flip, Encoding::data); }) != "");
}

}  // namespace atelier
