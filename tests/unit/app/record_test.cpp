#include "app/record.hpp"

#include "../gl/contexts.hpp"
#include "catch.hpp"
#include "image_io/image_io.hpp"
#include "studio.hpp"

namespace {

using namespace atelier;
using test::error_of;
using test::mentions;
using test::small_picture;
using test::Studio;

/// The values that a setting has in `frames` pictures.
template <class Value>
std::vector<Value> values_of(const char* name, const char* from, const char* to, int frames) {
  const Change change = change_of_setting(varied_setting(test::fake_settings(), name, from, to));
  std::vector<Value> values;
  for (int i = 0; i < frames; ++i) {
    Case picture = small_picture();
    change(picture, double(i) / frames);
    values.push_back(std::get<Value>(picture.settings.at(name)));
  }
  return values;
}

}  // namespace

TEST_CASE("a varied setting runs from the first value almost to the last", "[record]") {
  CHECK(values_of<double>("tint.brightness", "0", "4", 4) == std::vector<double>{0, 1, 2, 3});
  CHECK(values_of<double>("tint.brightness", "3", "1", 4) == std::vector<double>{3, 2.5, 2, 1.5});
  CHECK(values_of<int>("segments", "3", "5", 4) == std::vector<int>{3, 4, 4, 5});  // halves away from zero
  CHECK(values_of<int>("segments", "4096", "3", 1) == std::vector<int>{4096});
  CHECK(values_of<Colour>("tint.glow", "0,1,2", "2,1,0", 4) ==
        std::vector<Colour>{{0, 1, 2}, {0.5, 1, 1.5}, {1, 1, 1}, {1.5, 1, 0.5}});
  CHECK(values_of<Colour>("tint.glow", "#000000", "#ffffff", 2) ==
        std::vector<Colour>{Colour(0), Colour(0.5)});  // of light
}

TEST_CASE("a component that is the same at both ends stays the same", "[record]") {
  // x (1 - t) + x t is above 0.7 for some t; the range may end there.
  for (const Colour& colour : values_of<Colour>("tint.glow", "0.7,0,2", "0.7,1,2", 1000)) {
    CHECK(colour.r == 0.7);
    CHECK(colour.b == 2);
  }
}

TEST_CASE("an invalid variation is refused with the reason", "[record]") {
  const struct {
    const char *name, *from, *to;
    std::initializer_list<std::string_view> answer;
  } rows[] = {
      {"tint.color", "0", "1", {"'tint.color'", "tint.colour"}},
      {"tint.brightness", "0", "4.5", {"'tint.brightness'", "4.5", "0..4"}},
      {"tint.brightness", "-1", "4", {"'tint.brightness'", "-1", "0..4"}},
      {"tint.brightness", "nan", "4", {"'tint.brightness'", "nan", "0..4"}},
      {"tint.brightness", "dark", "4", {"'tint.brightness'", "dark", "0..4"}},
      {"tint.brightness", "2", "2.0", {"--vary tint.brightness=2..2.0", "the same"}},
      {"segments", "3", "4.5", {"'segments'", "4.5", "3..4096"}},
      {"tint.glow", "0,0,0", "0,0,2.5", {"'tint.glow'", "0,0,2.5", "0..2"}},
      {"tint.glow", "0,0,0", "1", {"'tint.glow'", "'1'", "R,G,B"}},
      {"tint.glow", "#ffffff", "1,1,1.0", {"--vary tint.glow=#ffffff..1,1,1.0", "the same"}},
      {"tint.brightness", "0,0,0", "1,1,1", {"'tint.brightness'", "'0,0,0'", "0..4"}},
      {"tint.colour", "red", "blue", {"--vary tint.colour=red..blue", "no numeric range"}},
      {"draw.wireframe", "off", "on", {"--vary draw.wireframe=off..on", "no numeric range"}},
  };
  for (const auto& row : rows) {
    INFO(row.name << '=' << row.from << ".." << row.to);
    const std::string words = error_of([&] { varied_setting(test::fake_settings(), row.name, row.from, row.to); });
    INFO(words);
    CHECK(mentions(words, row.answer));
  }
}

TEST_CASE("the camera orbits its target", "[record]") {
  const Camera start{.eye = {3, 1, 0}, .target = {1, 1, 0}, .up = {0, 2, 0}};
  const Change turn = turn_of_camera(start);
  const struct {
    double share;
    glm::dvec3 eye;
  } rows[] = {{0, {3, 1, 0}}, {0.25, {1, 1, -2}}, {0.5, {-1, 1, 0}}, {0.75, {1, 1, 2}}};
  for (const auto& row : rows) {
    Case picture = small_picture();
    turn(picture, row.share);
    INFO(row.share);
    CHECK(glm::distance(*picture.camera.eye, row.eye) < 1e-12);  // a few roundings of doubles near 3
    CHECK_FALSE(picture.camera.target);
  }
}

TEST_CASE("a recording draws each of its pictures once, on a fixed clock", "[record]") {
  Studio studio;
  const auto folder = studio.folder.path();
  const Change brighter = change_of_setting(varied_setting(test::fake_settings(), "tint.brightness", "0.5", "2"));
  record(*studio.painter, small_picture(), brighter, Encoding::linear, folder / "b.exr", 3);
  CHECK(studio.step.draws == 3);
  CHECK(studio.step.last_time == 2 / 24.0);
  CHECK_FALSE(std::filesystem::exists(folder / "b-0003.exr"));
  const double brightness[] = {0.5, 1, 1.5};
  for (int i = 0; i < 3; ++i) {
    Case picture = small_picture();
    picture.settings["tint.brightness"] = brightness[i];
    INFO(i);
    CHECK(read_image(folder / ("b-000" + std::to_string(i) + ".exr")) == studio.painter->paint(picture));
  }
  studio.step.draws = 0;
  record(*studio.painter, small_picture(), brighter, Encoding::linear, folder / "b.gif", 3);
  CHECK(studio.step.draws == 3);
  CHECK(std::filesystem::is_regular_file(folder / "b.gif"));
  CHECK(mentions(
      error_of([&] { record(*studio.painter, small_picture(), brighter, Encoding::linear, folder / "b.mp4", 3); }),
      {"b.mp4", ".gif"}));
}
