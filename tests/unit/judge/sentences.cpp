#include "judge/explain/sentences.hpp"

#include "catch.hpp"
#include "synthetic.hpp"

namespace atelier::judge::test {
namespace {

using atelier::test::mentions;

TEST_CASE("fractions, numbers and colours in words") {
  CHECK(percent(0) == "0 %");
  CHECK(percent(0.00001) == "under 0.01 %");
  CHECK(percent(0.0042) == "0.42 %");
  CHECK(percent(0.034) == "3 %");
  CHECK(percent(0.37) == "37 %");
  CHECK(percent(1) == "100 %");
  CHECK(grouped(7) == "7");
  CHECK(grouped(65536) == "65 536");
  CHECK(grouped(-1234567) == "-1 234 567");
  CHECK(colour_name({0, 0, 0, 1}) == "black");
  CHECK(colour_name({1, 1, 1, 1}) == "white");
  CHECK(colour_name({0.5f, 0.5f, 0.5f, 1}) == "grey");
  CHECK(colour_name({0.9f, 0.1f, 0.1f, 1}) == "red");
  CHECK(colour_name({0.3f, 0.3f, 0, 1}) == "dark yellow");
}

TEST_CASE("the position of the failing pixels in words") {
  struct Row {
    int x, y, width, height;
    const char* place;
  };
  for (const Row& row : {Row{0, 0, 30, 30, "upper left"}, Row{33, 33, 20, 20, "in the middle"},
                         Row{70, 40, 20, 20, "on the right"}, Row{0, 70, 90, 20, "in the lower third"},
                         Row{0, 0, 90, 45, "in the upper half"}, Row{0, 0, 90, 80, "all over the picture"}}) {
    INFO(row.place);
    Mask mask(90, 90);
    for (int y = row.y; y < row.y + row.height; ++y)
      for (int x = row.x; x < row.x + row.width; ++x) mask.set(x, y, true);
    CHECK(mentions(place_of(mask), {row.place}));
  }
  Mask scattered(90, 90);
  for (int i = 0; i < 90; i += 3) scattered.set(i, i, true);
  CHECK(place_of(scattered).empty());
  CHECK(place_of(Mask(90, 90)).empty());
  CHECK(place_of(Mask(1, 1)).empty());
}

TEST_CASE("found: the direction of the difference") {
  const Image right(32, 32, {0.2f, 0.2f, 0.2f, 1});
  struct Row {
    Rgba colour;
    const char* words;
  };
  for (const Row& row : {Row{{0.4f, 0.4f, 0.4f, 1}, "too bright"}, Row{{0.1f, 0.1f, 0.1f, 1}, "too dark"},
                         Row{{0.5f, 0.2f, 0.2f, 1}, "too red"}, Row{{0.2f, 0.2f, 0.05f, 1}, "short of blue"}}) {
    INFO(row.words);
    Image yours = right;
    for (int y = 0; y < 10; ++y)
      for (int x = 0; x < 10; ++x) yours.at(x, y) = row.colour;
    const JudgedCase c = picture_case();
    const Image a = compared_form(yours, c), b = compared_form(right, c);
    const std::string said = describe_failure(measure(a, b, c), a, b, c);
    INFO(said);
    CHECK(mentions(said, {row.words, "10 %", "/255", "upper left"}));
  }
}

TEST_CASE("found: only shifted") {
  Drawing moved_a_little;
  moved_a_little.offset_x = 0.12;
  JudgedCase c = picture_case(Profile::strict, Unit::colour, 60, 40);
  const Image a = compared_form(draw(moved_a_little), c), b = compared_form(draw({}), c);
  const Measurement measured = measure(a, b, c);
  REQUIRE(measured.shifted);
  REQUIRE(measured.difference.blob == 0);
  const std::string said = describe_failure(measured, a, b, c);
  INFO(said);
  CHECK(
      mentions(said, {"within 60/255", "pixels to the left"}));  // sample points to the right: the picture to the left
}

TEST_CASE("found, for a pass: its margin") {
  const JudgedCase c = picture_case();
  const Image right = compared_form(draw({}), c);
  CHECK(mentions(describe_pass(measure(right, right, c), c), {"equal"}));
  const Image noisy = compared_form(with_noise(draw({}), 1), c);
  CHECK(mentions(describe_pass(measure(noisy, right, c), c), {"1/255", "3/255"}));
}

}  // namespace
}  // namespace atelier::judge::test
