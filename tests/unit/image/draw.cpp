// Pictures made from other pictures.
#include "image/draw.hpp"

#include <limits>

#include "catch.hpp"
#include "image/colour.hpp"
#include "pictures.hpp"

using namespace atelier;
using namespace atelier::test;

TEST_CASE("crop, and boxes around a pixel") {
  const Image image = grey(10, 8, [](int x, int y) { return x + 10 * y; });
  const Image part = crop(image, {3, 2, 4, 5});
  CHECK(part.width() == 4);
  CHECK(part.height() == 5);
  CHECK(part.at(0, 0).r == 23);
  CHECK(part.at(3, 4).r == 66);
  struct Row {
    Position centre;
    int size;
    Box box;
  };
  for (const Row& row : {Row{{5, 4}, 4, {3, 2, 4, 4}},
                         {{0, 0}, 4, {0, 0, 4, 4}},
                         {{9, 7}, 4, {6, 4, 4, 4}},
                         {{5, 4}, 99, {0, 0, 10, 8}}}) {
    const Box box = box_around(image, row.centre, row.size, row.size);
    CHECK(box.x == row.box.x);
    CHECK(box.y == row.box.y);
    CHECK(box.width == row.box.width);
    CHECK(box.height == row.box.height);
    CHECK(crop(image, box).width() == box.width);
  }
  for (const Box& box : {Box{0, 0, 11, 1}, {-1, 0, 2, 2}, {0, 7, 1, 2}, {0, 0, 0, 1}, {2147483647, 0, 2, 2}})
    CHECK(mentions(error_of([&] { crop(image, box); }), {"10 x 8"}));
}

TEST_CASE("enlarging repeats pixels") {
  const Image big = enlarge(grey(3, 2, [](int x, int y) { return x + 3 * y; }), 8);
  CHECK(big.width() == 24);
  CHECK(big.height() == 16);
  CHECK(big.at(7, 7).r == 0);
  CHECK(big.at(8, 7).r == 1);
  CHECK(big.at(23, 15).r == 5);
  CHECK_FALSE(error_of([] { enlarge(Image(2, 2), 0); }).empty());
  CHECK(mentions(error_of([] { enlarge(Image(200, 2), 100); }), {"16384"}));
  CHECK_FALSE(error_of([] { enlarge(Image(16384, 1), 16384); }).empty());
}

TEST_CASE("shrinking averages over the area, and keeps the mean") {
  const Image four = shrink_to(grey(4, 4, [](int x, int y) { return x + 4 * y; }), 2);
  CHECK(four.width() == 2);
  CHECK(four.at(0, 0).r == Approx(2.5f));
  CHECK(four.at(1, 1).r == Approx(12.5f));
  const Image image = waves(45, 31);
  const Image small = shrink_to(image, 15);
  CHECK(small.width() == 15);
  CHECK(small.height() == 10);
  const auto mean = [](const Image& i) {
    double sum = 0;
    for (const Rgba& p : i.pixels()) sum += p.g;
    return sum / double(i.pixels().size());
  };
  CHECK(mean(small) == Approx(mean(image)).margin(1e-6));  // sums of floats
  CHECK(small.at(3, 3).a == Approx(1).margin(1e-6));
  CHECK(shrink_to(image, 45) == image);
  CHECK(shrink_to(Image(16384, 1, {1, 1, 1, 1}), 7).height() == 1);
  CHECK_FALSE(error_of([&] { shrink_to(image, 0); }).empty());
}

TEST_CASE("side by side") {
  const Image row[] = {Image(3, 5, {1, 0, 0, 1}), Image(4, 2, {0, 1, 0, 1})};
  const Image both = side_by_side(row, 2, {0, 0, 1, 1});
  CHECK(both.width() == 9);
  CHECK(both.height() == 5);
  CHECK(both.at(2, 4) == Rgba{1, 0, 0, 1});
  CHECK(both.at(3, 0) == Rgba{0, 0, 1, 1});
  CHECK(both.at(5, 1) == Rgba{0, 1, 0, 1});
  CHECK(both.at(5, 2) == Rgba{0, 0, 1, 1});
  CHECK_FALSE(error_of([] { side_by_side({}); }).empty());
  CHECK_FALSE(error_of([&] { side_by_side(row, -1); }).empty());
  const Image wide[] = {Image(16384, 1), Image(16384, 1)};
  CHECK(mentions(error_of([&] { side_by_side(wide); }), {"16384"}));
}

TEST_CASE("signed difference: grey where equal, brighter where yours has more") {
  Image yours(2, 1, {0.5f, 0.5f, 0.5f, 1}), reference = yours;
  yours.at(1, 0) = {0.51f, 0.49f, std::numeric_limits<float>::quiet_NaN(), 0};
  const Image d = signed_difference(yours, reference);
  CHECK(d.at(0, 0) == Rgba{0.5f, 0.5f, 0.5f, 1});
  CHECK(d.at(1, 0).r == Approx(0.66f).margin(1e-5));
  CHECK(d.at(1, 0).g == Approx(0.34f).margin(1e-5));
  CHECK(d.at(1, 0).b == 0);
  CHECK_FALSE(error_of([&] { signed_difference(yours, Image(1, 1)); }).empty());
}

TEST_CASE("the heat map's colours get steadily lighter, from black to nearly white") {
  double before = -1;
  for (int i = 0; i <= 100; ++i) {
    const double lightness = xyz_to_lab(linear_to_xyz(srgb_decode(heat_colour(float(i) / 100)))).l;
    CHECK(lightness > before);
    if (i > 0)
      CHECK(lightness - before < 2.5);  // 97 over a hundred steps: evenly, to within a factor of two and a half
    before = lightness;
  }
  CHECK(before > 95);
  CHECK(heat_colour(-1) == heat_colour(0));
  CHECK(heat_colour(2) == heat_colour(1));
  CHECK(heat_colour(std::numeric_limits<float>::quiet_NaN()) == heat_colour(0));
  CHECK(heat_map(Image(1, 1, {0.2f, 0, 0, 1}), 0.4f).at(0, 0) == heat_colour(0.5f));
  CHECK_FALSE(error_of([] { heat_map(Image(1, 1), 0); }).empty());
}

TEST_CASE("overlay") {
  Mask mask(4, 3);
  mask.set(2, 1, true);
  const Image image = overlay(Image(4, 3, {1, 1, 1, 1}), mask, {1, 0, 0, 1});
  CHECK(image.at(2, 1) == Rgba{1, 0, 0, 1});
  CHECK(image.at(1, 1).r == Approx(0.5f));
  CHECK(image.at(1, 1).r == image.at(1, 1).b);
  CHECK_FALSE(error_of([&] { overlay(Image(3, 3), mask); }).empty());
  CHECK(to_image(mask).at(2, 1) == Rgba{1, 1, 1, 1});
  CHECK(to_image(mask).at(0, 0) == Rgba{0, 0, 0, 1});
}
