#include "case/settings.hpp"

#include "case/suggest.hpp"
#include "catch.hpp"

using namespace atelier;
using test::error_of;

namespace {

Settings shadow_settings() {
  return Settings({
      {.name = "shadow.resolution", .fallback = 1024, .low = 32, .high = 8192, .help = "texels"},
      {.name = "shadow.bias", .fallback = 0.5, .low = 0, .high = 2, .help = "texels"},
      {.name = "shadow.kind", .fallback = std::string("slope"), .choices = {"none", "constant", "slope"}, .help = ""},
      {.name = "shadow.on", .fallback = true, .help = ""},
      {.name = "shadow.format", .fallback = std::string("24"), .choices = {"16", "24", "32f"}, .help = "bits"},
  });
}

}  // namespace

TEST_CASE("settings start at their defaults") {
  const Settings settings = shadow_settings();
  CHECK(settings.integer("shadow.resolution") == 1024);
  CHECK(settings.real("shadow.bias") == 0.5);
  CHECK(settings.choice("shadow.kind") == "slope");
  CHECK(settings.flag("shadow.on"));
}

TEST_CASE("settings are set from text and from values, ends of ranges included") {
  Settings settings = shadow_settings();
  settings.set("shadow.resolution", "32");
  CHECK(settings.integer("shadow.resolution") == 32);
  settings.set("shadow.resolution", SettingValue(8192));
  CHECK(settings.integer("shadow.resolution") == 8192);
  settings.set("shadow.bias", "2");
  CHECK(settings.real("shadow.bias") == 2);
  settings.set("shadow.bias", SettingValue(1));
  CHECK(settings.real("shadow.bias") == 1);
  settings.set("shadow.bias", "1e-3");
  CHECK(settings.real("shadow.bias") == 1e-3);
  settings.set("shadow.kind", std::string("none"));
  CHECK(settings.choice("shadow.kind") == "none");
  settings.set("shadow.format", SettingValue(16));  // a file in which nobody knew that it is a name
  CHECK(settings.choice("shadow.format") == "16");
  for (const char* off : {"off", "false"}) {
    settings.set("shadow.on", off);
    CHECK_FALSE(settings.flag("shadow.on"));
    settings.set("shadow.on", SettingValue(true));
  }
}

TEST_CASE("settings refuse text with the value and what is allowed") {
  struct Row {
    const char *name, *text, *words;
  };
  const Row rows[] = {
      {"shadow.resolution", "31", "setting 'shadow.resolution': 31 is not allowed"},
      {"shadow.resolution", "8193", "it takes 32..8192"},
      {"shadow.resolution", "64.0", "it takes 32..8192"},
      {"shadow.resolution", "64 ", "'64 ' is not allowed"},
      {"shadow.resolution", "", "'' is not allowed"},
      {"shadow.resolution", "99999999999999999999", "it takes 32..8192"},
      {"shadow.bias", "nan", "it takes 0..2"},
      {"shadow.bias", "inf", "it takes 0..2"},
      {"shadow.bias", "-1e-300", "it takes 0..2"},
      {"shadow.bias", "1e999", "it takes 0..2"},
      {"shadow.kind", "Slope", "it takes none, constant, slope"},
      {"shadow.kind", "\x1b[31m", "\xEF\xBF\xBD[31m"},
      {"shadow.on", "maybe", "it takes on, off"},
      {"shadow.resolutoin", "64", "did you mean 'shadow.resolution'?"},
      {"fog", "64", "known are shadow.resolution, shadow.bias, shadow.kind, shadow.on, shadow.format"},
  };
  for (const Row& row : rows) {
    Settings settings = shadow_settings();
    const std::string message = error_of([&] { settings.set(row.name, row.text); });
    INFO(row.name << " = " << row.text << " -> " << message);
    CHECK(message.find(row.words) != std::string::npos);
    CHECK(settings.integer("shadow.resolution") == 1024);  // a refused value changes nothing
  }
}

TEST_CASE("typed values do not convert, except a whole number to a real or to a choice of that name") {
  struct Row {
    const char* name;
    SettingValue value;
    const char* words;
  };
  const Row rows[] = {
      {"shadow.resolution", 64.0, "64 is not allowed; it takes 32..8192"},
      {"shadow.resolution", true, "on is not allowed"},
      {"shadow.resolution", 31, "31 is not allowed"},
      {"shadow.bias", true, "on is not allowed"},
      {"shadow.on", 1, "1 is not allowed; it takes on, off"},
      {"shadow.kind", 2, "2 is not allowed"},
      {"shadow.kind", SettingValue(std::string("box")), "'box' is not allowed"},
  };
  for (const Row& row : rows) {
    Settings settings = shadow_settings();
    const std::string message = error_of([&] { settings.set(row.name, row.value); });
    INFO(row.name << " -> " << message);
    CHECK(message.find(row.words) != std::string::npos);
  }
}

TEST_CASE("settings refuse a wrong declaration and a wrong reading") {
  CHECK(error_of([] {
          Settings(
              {{.name = "a", .fallback = 1, .low = 0, .high = 2}, {.name = "a", .fallback = 1, .low = 0, .high = 2}});
        }) == "setting 'a' is declared twice");
  CHECK(error_of([] { Settings({{.name = "a", .fallback = 3, .low = 0, .high = 2}}); }) ==
        "setting 'a': 3 is not allowed; it takes 0..2");
  CHECK(error_of([] { shadow_settings().flag("shadow.bias"); }) ==
        "setting 'shadow.bias' is a number, and was read as on or off");
  CHECK(error_of([] { shadow_settings().integer("shadow"); }).find("unknown setting 'shadow'") == 0);
}

TEST_CASE("edit distance counts insertions, deletions, replacements and swaps") {
  struct Row {
    const char *a, *b;
    std::size_t distance;
  };
  const Row rows[] = {{"", "", 0},         {"", "abc", 3},           {"size", "size", 0}, {"sixe", "size", 1},
                      {"isze", "size", 1}, {"kitten", "sitting", 3}, {"ca", "abc", 3},    {"sizes", "size", 1}};
  for (const Row& row : rows) {
    INFO(row.a << " / " << row.b);
    CHECK(edit_distance(row.a, row.b) == row.distance);
    CHECK(edit_distance(row.b, row.a) == row.distance);
  }
}

TEST_CASE("only a near name is suggested") {
  const std::vector<std::string> known = {"camera", "scene", "size", "settings"};
  CHECK(nearest_name("camrea", known) == "camera");
  CHECK(nearest_name("x", known).empty());
  CHECK(nearest_name("", known).empty());
  CHECK(nearest_name(std::string(100000, 'a'), known).empty());
  CHECK(suggestion("zzz", {}) == "; there are none");
  CHECK(suggestion("scnee", known) == "; did you mean 'scene'?");
}
