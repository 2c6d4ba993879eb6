#include "app/window/colour_codes.hpp"

#include <limits>

#include "catch.hpp"

namespace {

using namespace atelier;

SettingSpec colour_spec(double low, double high) {
  return {.name = "sky", .fallback = Colour(low), .low = low, .high = high};
}

}  // namespace

TEST_CASE("the panel shows a colour by its sRGB codes", "[colour_codes]") {
  const struct {
    const char* name;
    Colour colour;
    glm::ivec3 codes;
  } rows[] = {
      {"black", {0, 0, 0}, {0, 0, 0}},
      {"white", {1, 1, 1}, {255, 255, 255}},
      {"as it is typed", parse_colour("#3380ff").value(), {0x33, 0x80, 0xff}},
      {"a fifth and a half of the light", {0.2, 0.5, 1}, {124, 188, 255}},  // 123.55, 187.52
      {"more than a screen shows", {2, 4, 1e6}, {345, 465, 85059}},
      {"less than none", {-0.001, 0, 0}, {-3, 0, 0}},
      {"what no code has room for", {1e300, -1e300, std::numeric_limits<double>::max()}, {1000000, -1000000, 1000000}},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    const glm::ivec3 codes = codes_of(row.colour);
    INFO(codes.r << ' ' << codes.g << ' ' << codes.b);
    CHECK(codes == row.codes);
  }
}

TEST_CASE("an edited code is decoded to linear light and clamped to the range", "[colour_codes]") {
  const struct {
    const char* name;
    double low, high;
    Colour before;
    glm::ivec3 codes;
    Colour after;
  } rows[] = {
      {"nothing is touched", 0, 1, {0.2, 1.0 / 3, 1e-9}, codes_of({0.2, 1.0 / 3, 1e-9}), {0.2, 1.0 / 3, 1e-9}},
      {"one component", 0, 1, {0.2, 1.0 / 3, 1e-9}, {124, 255, 0}, {0.2, 1, 1e-9}},
      {"all", 0, 1, {0, 0, 0}, {0x33, 0x80, 0xff}, parse_colour("#3380ff").value()},
      {"above the range", 0, 0.5, {0, 0, 0}, {255, 0, 0}, {0.5, 0, 0}},
      {"below the range", 0.25, 1, {0.5, 0.5, 0.5}, {0, 188, 188}, {0.25, 0.5, 0.5}},
      {"beyond screens", 0, 1e300, {0, 0, 0}, {510, 0, 0}, {4.9538457515920408, 0, 0}},  // ((2 + 0.055) / 1.055)^2.4
  };
  for (const auto& row : rows) {
    INFO(row.name);
    const Colour after = with_codes(colour_spec(row.low, row.high), row.before, row.codes);
    INFO(setting_text(after));
    for (int i : {0, 1, 2}) CHECK(after[i] == Approx(row.after[i]).epsilon(1e-14));  // a few roundings and a power
  }
}

TEST_CASE("every code survives decoding and encoding", "[colour_codes]") {
  for (int code = 0; code < 256; ++code)
    CHECK(codes_of(with_codes(colour_spec(0, 1), Colour(-1), glm::ivec3(code))) == glm::ivec3(code));
}
