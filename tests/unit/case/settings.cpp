#include "case/settings.hpp"

#include <cmath>
#include <limits>

#include "base/near_names.hpp"
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
      {.name = "shadow.tint", .fallback = Colour(0.1, 0.2, 0.3), .low = 0, .high = 1.1, .help = "light in the shadow"},
  });
}

}  // namespace

TEST_CASE("settings start at their defaults") {
  const Settings settings = shadow_settings();
  CHECK(settings.integer("shadow.resolution") == 1024);
  CHECK(settings.real("shadow.bias") == 0.5);
  CHECK(settings.choice("shadow.kind") == "slope");
  CHECK(settings.flag("shadow.on"));
  CHECK(settings.colour("shadow.tint") == Colour(0.1, 0.2, 0.3));
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
  settings.set("shadow.tint", "0,1.1,5e-1");
  CHECK(settings.colour("shadow.tint") == Colour(0, 1.1, 0.5));
  settings.set("shadow.tint", SettingValue(Colour(1.1, 0, 1)));
  CHECK(settings.colour("shadow.tint") == Colour(1.1, 0, 1));
  settings.set("shadow.tint", "#ff0000");
  CHECK(settings.colour("shadow.tint") == Colour(1, 0, 0));
}

TEST_CASE("invalid text is refused with the value and what is allowed") {
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
      {"shadow.tint", "0,0.5,1.2",
       "setting 'shadow.tint': 0,0.5,1.2 is not allowed; it takes R,G,B in linear light, each 0..1.1, or sRGB codes "
       "#rrggbb"},
      {"shadow.tint", "-1e-300,0,0", "-1e-300,0,0 is not allowed"},
      {"shadow.tint", "0,0,nan", "'0,0,nan' is not allowed; it takes R,G,B"},
      {"shadow.tint", "0.5", "'0.5' is not allowed; it takes R,G,B"},
      {"shadow.tint", "#ffff", "'#ffff' is not allowed"},
      {"shadow.tint", "red", "'red' is not allowed"},
      {"shadow.bias", "0,0,0", "'0,0,0' is not allowed; it takes 0..2"},
      {"shadow.resolutoin", "64", "did you mean 'shadow.resolution'?"},
      {"fog", "64", "known are shadow.resolution, shadow.bias, shadow.kind, shadow.on, shadow.format, shadow.tint"},
  };
  for (const Row& row : rows) {
    Settings settings = shadow_settings();
    const std::string message = error_of([&] { settings.set(row.name, row.text); });
    INFO(row.name << " = " << row.text << " -> " << message);
    CHECK(message.find(row.words) != std::string::npos);
    CHECK(settings.integer("shadow.resolution") == 1024);  // a refused value changes nothing
  }
}

TEST_CASE("a colour is written as light or as sRGB codes, and read back the same") {
  const struct {
    const char* text;
    Colour colour;
  } read[] = {
      {"0,0,0", {0, 0, 0}},
      {"0.2,0.5,1", {0.2, 0.5, 1}},
      {"-1,+2.5,1e-300", {-1, 2.5, 1e-300}},
      {"#000000", {0, 0, 0}},
      {"#ffffff", {1, 1, 1}},
      // By hand: 51/255 and 128/255 on the curve's power, 10/255 on its straight part, which ends at 0.04045.
      {"#33800a",
       {std::pow((0.2 + 0.055) / 1.055, 2.4), std::pow((128 / 255.0 + 0.055) / 1.055, 2.4), 10 / 255.0 / 12.92}},
      {"#3380FF", parse_colour("#3380ff").value()},
  };
  for (const auto& row : read) {
    INFO(row.text);
    const Colour colour = parse_colour(row.text).value();
    for (int i : {0, 1, 2}) CHECK(colour[i] == Approx(row.colour[i]).epsilon(1e-15));  // a few roundings of a double
    CHECK(parse_colour(setting_text(colour)) == colour);
  }
  const std::pair<Colour, const char*> written[] = {
      {{0.2, 0.5, 1}, "0.2,0.5,1"},
      {{1.0 / 3, 1e-300, 0.1 + 0.2}, "0.3333333333333333,1e-300,0.30000000000000004"},
      {{-0.5, 1e300, 5e-324}, "-0.5,1e+300,5e-324"}};
  for (const auto& [colour, text] : written) {
    CHECK(setting_text(colour) == text);
    CHECK(parse_colour(text) == colour);
  }
  for (const char* text :
       {"",         "1",       "1,1",     "1,1,1,",  "1,1,1,1",  ",1,1",      "1,,1",     "1, 1,1", " 1,1,1", "1,1,1 ",
        "1;1;1",    "a,b,c",   "nan,1,1", "1,inf,1", "1,1,-inf", "1e999,1,1", "0x1,1,1",  "#",      "#fff",   "#fffff",
        "#fffffff", "#ff ff0", "#gg0000", "#+10000", "#-10000",  "#0x0000",   " #ffffff", "ffffff", "red"}) {
    INFO("'" << text << "'");
    CHECK_FALSE(parse_colour(text));
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
      {"shadow.tint", 1, "1 is not allowed; it takes R,G,B in linear light, each 0..1.1"},
      {"shadow.tint", 0.5, "0.5 is not allowed; it takes R,G,B"},
      {"shadow.tint", true, "on is not allowed; it takes R,G,B"},
      {"shadow.tint", SettingValue(std::string("#ff0000")), "'#ff0000' is not allowed"},
      {"shadow.tint", SettingValue(Colour(0, 0, 1.2)), "0,0,1.2 is not allowed"},
      {"shadow.tint", SettingValue(Colour(std::numeric_limits<double>::quiet_NaN(), 0, 0)), "nan,0,0 is not allowed"},
      {"shadow.tint", SettingValue(Colour(0, std::numeric_limits<double>::infinity(), 0)), "0,inf,0 is not allowed"},
      {"shadow.bias", SettingValue(Colour(1)), "1,1,1 is not allowed; it takes 0..2"},
      {"shadow.resolution", SettingValue(Colour(64)), "64,64,64 is not allowed; it takes 32..8192"},
      {"shadow.on", SettingValue(Colour(1)), "1,1,1 is not allowed; it takes on, off"},
      {"shadow.kind", SettingValue(Colour(1)), "1,1,1 is not allowed; it takes none, constant, slope"},
  };
  for (const Row& row : rows) {
    Settings settings = shadow_settings();
    const std::string message = error_of([&] { settings.set(row.name, row.value); });
    INFO(row.name << " -> " << message);
    CHECK(message.find(row.words) != std::string::npos);
  }
}

TEST_CASE("wrong declarations and wrong types on reading are refused") {
  CHECK(error_of([] {
          Settings(
              {{.name = "a", .fallback = 1, .low = 0, .high = 2}, {.name = "a", .fallback = 1, .low = 0, .high = 2}});
        }) == "setting 'a' is declared twice");
  CHECK(error_of([] { Settings({{.name = "a", .fallback = 3, .low = 0, .high = 2}}); }) ==
        "setting 'a': 3 is not allowed; it takes 0..2");
  CHECK(error_of([] { shadow_settings().flag("shadow.bias"); }) ==
        "setting 'shadow.bias' is a number, but was read as on or off");
  CHECK(error_of([] { Settings({{.name = "a", .fallback = Colour(0, 0, 2), .low = 0, .high = 1}}); }) ==
        "setting 'a': 0,0,2 is not allowed; it takes R,G,B in linear light, each 0..1, or sRGB codes #rrggbb");
  CHECK(error_of([] { shadow_settings().colour("shadow.bias"); }) ==
        "setting 'shadow.bias' is a number, but was read as a colour");
  CHECK(error_of([] { shadow_settings().real("shadow.tint"); }) ==
        "setting 'shadow.tint' is a colour, but was read as a number");
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

TEST_CASE("only a similar name is suggested") {
  const std::vector<std::string> known = {"camera", "scene", "size", "settings"};
  CHECK(nearest_name("camrea", known) == "camera");
  CHECK(nearest_name("x", known).empty());
  CHECK(nearest_name("", known).empty());
  CHECK(nearest_name(std::string(100000, 'a'), known).empty());
  CHECK(suggestion("zzz", {}) == "; there are none");
  CHECK(suggestion("scnee", known) == "; did you mean 'scene'?");
}
