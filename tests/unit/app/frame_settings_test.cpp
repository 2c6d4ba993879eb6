#include "app/frame_settings.hpp"

#include <cmath>

#include "catch.hpp"
#include "image/average.hpp"
#include "image/error.hpp"
#include "studio.hpp"

namespace {

using namespace atelier;
using test::error_of;
using test::mentions;
using test::small_picture;
using test::Studio;

using Values = std::map<std::string, std::string>;

Settings frame_settings_with(const Values& values) {
  Settings settings(frame_settings());
  for (const auto& [name, value] : values) settings.set(name, value);
  return settings;
}

Case picture_with(const Values& values, const char* output = "colour") {
  Case picture = small_picture();
  picture.output = output;
  const Settings settings = frame_settings_with(values);
  for (const auto& [name, value] : values) picture.settings[name] = settings.value(name);
  return picture;
}

/// The largest difference of a channel, in sRGB codes of 255.
double codes_apart(const Image& a, const Image& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Rgba p = srgb_encode(a.pixels()[i]), q = srgb_encode(b.pixels()[i]);
    for (const float difference : {p.r - q.r, p.g - q.g, p.b - q.b})
      most = std::max(most, 255.0 * std::abs(difference));
  }
  return most;
}

}  // namespace

TEST_CASE("the frame's target follows from the settings and the output's encoding", "[frame]") {
  const struct {
    const char* name;
    Values values;
    Encoding encoding;
    ColourFormat colour;
    int samples;
  } rows[] = {
      {"the defaults", {}, Encoding::linear, ColourFormat::rgba32f, 1},
      {"half floats", {{"frame.format", "16f"}}, Encoding::linear, ColourFormat::rgba16f, 1},
      {"8 bits of light", {{"frame.format", "8"}}, Encoding::linear, ColourFormat::srgb8, 1},
      {"8 bits of codes", {{"frame.format", "8"}}, Encoding::srgb, ColourFormat::rgba8, 1},
      {"half floats of codes", {{"frame.format", "16f"}}, Encoding::srgb, ColourFormat::rgba16f, 1},
      {"data", {{"frame.format", "8"}, {"frame.samples", "4"}}, Encoding::data, ColourFormat::rgba32f, 1},
      {"samples", {{"frame.samples", "4"}}, Encoding::linear, ColourFormat::rgba32f, 4},
      {"samples of codes", {{"frame.samples", "4"}}, Encoding::srgb, ColourFormat::rgba32f, 4},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    const TargetSpec expected{
        .width = 7, .height = 5, .colour = row.colour, .depth = DepthFormat::depth32f, .samples = row.samples};
    CHECK(frame_target({7, 5}, row.encoding, DepthFormat::depth32f, frame_settings_with(row.values)) == expected);
  }
  const Settings thrice = frame_settings_with({{"frame.supersampling", "3"}});
  CHECK(supersampling_of(Encoding::linear, thrice) == 3);
  CHECK(supersampling_of(Encoding::srgb, thrice) == 3);
  CHECK(supersampling_of(Encoding::data, thrice) == 1);
}

TEST_CASE("the frame settings accept only allowed values", "[frame]") {
  const struct {
    const char *name, *value, *allowed;
  } rows[] = {{"frame.format", "10", "32f, 16f, 8"}, {"frame.format", "srgb8", "32f, 16f, 8"},
              {"frame.samples", "2", "1, 4"},        {"frame.samples", "0", "1, 4"},
              {"frame.supersampling", "0", "1..4"},  {"frame.supersampling", "5", "1..4"},
              {"frame.supersampling", "1.5", "1..4"}};
  for (const auto& row : rows) {
    INFO(row.name << "=" << row.value);
    CHECK(mentions(error_of([&] {
                     frame_settings_with({{row.name, row.value}});
                   }),
                   {row.name, row.value, row.allowed}));
  }
}

TEST_CASE("a window starts with 8 bits and 4 samples, if the driver supports them", "[frame]") {
  std::vector<SettingSpec> specs = frame_settings();
  specs.push_back({.name = "other", .fallback = 3, .low = 0, .high = 9});
  const Settings window(with_window_defaults(specs, 8)), poor(with_window_defaults(specs, 3));
  CHECK(window.choice("frame.format") == "8");
  CHECK(window.choice("frame.samples") == "4");
  CHECK(window.integer("frame.supersampling") == 1);
  CHECK(window.integer("other") == 3);
  CHECK(poor.choice("frame.format") == "8");
  CHECK(poor.choice("frame.samples") == "1");
}

TEST_CASE("pictures are floats with one sample by default", "[frame]") {
  Studio studio;
  const Image picture = studio.painter->paint(small_picture());
  CHECK(std::size_t(studio.painter->cost().gl.target_bytes) == 32 * 24 * (16 + 4));
  // By hand: the target that there was before there were settings.
  const Target target(studio.context->gl(), {.width = 32, .height = 24});
  studio.step.draw({target, studio.step.camera()}, Settings(studio.step.description().settings));
  CHECK(target.read_colour(studio.context->gl()) == picture);
}

TEST_CASE("a picture has the precision of its format", "[frame]") {
  Studio studio;
  const Image full = studio.painter->paint(small_picture());
  const Image bytes = studio.painter->paint(picture_with({{"frame.format", "8"}}));
  CHECK(codes_apart(bytes, full) <= 0.6);  // what Direct3D's specification asks of drivers
  CHECK(codes_apart(bytes, full) > 0.3);
  const Image halves = studio.painter->paint(picture_with({{"frame.format", "16f"}}));
  CHECK_FALSE(halves == full);
  for (std::size_t i = 0; i < full.pixels().size(); ++i) {
    const float g = full.pixels()[i].g;
    REQUIRE(std::abs(halves.pixels()[i].g - g) <= g * 0x1p-10f);  // ten bits, whether the driver rounds or cuts
  }
}

TEST_CASE("data outputs are always floats with one sample", "[frame]") {
  Studio studio;
  const Values all = {{"frame.format", "8"}, {"frame.samples", "4"}, {"frame.supersampling", "3"}};
  for (const char* output : {"depth", "normal", "position", "texcoord"}) {
    INFO(output);
    const Image plain = studio.painter->paint(picture_with({}, output));
    CHECK(studio.painter->paint(picture_with(all, output)) == plain);
  }
}

TEST_CASE("supersampling is the mean of the larger picture", "[frame]") {
  Studio studio;
  for (const int factor : {2, 3, 4})
    for (const char* samples : {"1", "4"}) {
      INFO(factor << " with " << samples);
      Case larger = picture_with({{"frame.samples", samples}});
      larger.size *= factor;
      const Image expected = averaged(studio.painter->paint(larger), factor, Encoding::linear);
      const auto cost = studio.painter->cost().gl.target_bytes;
      const Image mean = studio.painter->paint(
          picture_with({{"frame.samples", samples}, {"frame.supersampling", std::to_string(factor)}}));
      REQUIRE(mean.width() == 32);
      REQUIRE(mean.height() == 24);
      CHECK(mean == expected);
      CHECK(studio.painter->cost().gl.target_bytes == cost);
    }
}

TEST_CASE("with more samples, a pixel is closer to its mean", "[frame]") {
  Studio studio;
  Case finest = picture_with({{"frame.supersampling", "4"}});
  finest.size *= 8;
  const Image truth = averaged(studio.painter->paint(finest), 8, Encoding::linear);
  const auto error = [&](const char* samples, const char* supersampling) {
    return error_of(
        studio.painter->paint(picture_with({{"frame.samples", samples}, {"frame.supersampling", supersampling}})),
        truth, ErrorMetric::rmse);
  };
  const double plain = error("1", "1"), four = error("4", "1"), twice = error("1", "2"), finer = error("1", "4");
  INFO("1 sample " << plain << ", 4 samples " << four << ", 2x2 " << twice << ", 4x4 " << finer);
  // The edges of a box whose faces have one colour each: nothing else has an error. Half of it or less is left by four
  // times the samples: between 4^-1/2, as for samples thrown at random, and 4^-3/4, as for a grid along a slanted edge.
  CHECK(four < 0.6 * plain);
  CHECK(twice < 0.6 * plain);
  CHECK(finer < 0.6 * twice);
}

TEST_CASE("a size that the driver does not support is refused, naming the setting", "[frame]") {
  Studio studio;
  Case wide = picture_with({{"frame.supersampling", "2"}});
  const int longest = longest_side(studio.context->gl());
  wide.size = {longest / 2 + 1, 4};
  const std::string side = std::to_string(longest / 2 + 1), doubled = std::to_string(2 * (longest / 2 + 1));
  CHECK(mentions(error_of([&] { studio.painter->paint(wide); }),
                 {"frame.supersampling=2", side + "x4", doubled + "x8", std::to_string(longest)}));
  wide.size.x = longest / 2;
  wide.size.y = 1;
  CHECK(studio.painter->paint(wide).width() == longest / 2);
}

TEST_CASE("the cost of several samples is counted", "[frame]") {
  Studio studio;
  studio.painter->paint(small_picture());
  const GlCounts plain = studio.painter->cost().gl;
  studio.painter->paint(picture_with({{"frame.samples", "4"}, {"frame.format", "8"}}));
  const GlCounts four = studio.painter->cost().gl;
  CHECK(four.target_bytes == 32 * 24 * (4 + 4) * (4 + 1));
  CHECK(four.passes == plain.passes + 1);  // the resolve
  CHECK(four.draws == plain.draws);
}
