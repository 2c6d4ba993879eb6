#include "app/window/restart.hpp"

#include "app/window/viewer.hpp"
#include "base/file.hpp"
#include "catch.hpp"

namespace {

using namespace atelier;
using test::mentions;
namespace fs = std::filesystem;

void touch(const fs::path& file, int seconds) {
  fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(seconds));
}

}  // namespace

TEST_CASE("the libraries of the used steps are found in the order of the search path", "[restart]") {
  const TemporaryFolder folder;
  const fs::path mine = folder.path() / "mine", solutions = folder.path() / "solutions";
  for (const char* step : {"01-a", "02-b", "03-c"}) write_file(solutions / step / "libstep.so", std::string_view("s"));
  write_file(mine / "02-b/libstep.so", std::string_view("m"));
  const StepIdentity identity{"02-b", {"01-a", "02-b"}};
  const Snapshot libraries = step_libraries(identity, Implementations({{mine, ""}, {solutions, ""}}));
  REQUIRE(libraries.size() == 2);
  CHECK(libraries.contains(solutions / "01-a/libstep.so"));
  CHECK(libraries.contains(mine / "02-b/libstep.so"));
  fs::remove(mine / "02-b/libstep.so");
  fs::remove(solutions / "02-b/libstep.so");
  CHECK(step_libraries(identity, Implementations({{mine, ""}, {solutions, ""}})).size() == 1);
}

TEST_CASE("shaders are found in every root; limited roots apply only to their step", "[restart]") {
  const TemporaryFolder folder;
  const fs::path mine = folder.path() / "mine", other = folder.path() / "other";
  for (const fs::path& file :
       {mine / "01-a/a.glsl", mine / "01-a/a.cpp", mine / "02-b/b.frag", other / "01-a/a.vert", other / "02-b/b.geom"})
    write_file(file, std::string_view("x"));
  const Snapshot shaders =
      step_shaders(Implementations({{mine, ""}, {other, "02-b"}, {folder.path() / "missing", ""}}));
  CHECK(shaders.size() == 3);
  CHECK(shaders.contains(mine / "01-a/a.glsl"));
  CHECK(shaders.contains(mine / "02-b/b.frag"));
  CHECK(shaders.contains(other / "02-b/b.geom"));
}

TEST_CASE("a watch reports a change once, after the files have stopped changing", "[restart]") {
  const TemporaryFolder folder;
  const fs::path library = folder.path() / "01-a/libstep.so";
  write_file(library, std::string_view("one"));
  const StepIdentity identity{"01-a", {"01-a"}};
  const Implementations implementations({{folder.path(), ""}});
  const auto look = [&] { return step_libraries(identity, implementations); };

  Watch watch(look());
  CHECK_FALSE(watch.settled_change(look()));
  touch(library, 1);
  CHECK_FALSE(watch.settled_change(look()));  // it may still be being written
  touch(library, 1);
  CHECK_FALSE(watch.settled_change(look()));  // it was
  CHECK(watch.settled_change(look()));
  CHECK_FALSE(watch.settled_change(look()));

  const auto time = fs::last_write_time(library);
  write_file(library, std::string_view("four"));
  fs::last_write_time(library, time);  // another size is a change by itself
  CHECK_FALSE(watch.settled_change(look()));
  CHECK(watch.settled_change(look()));
}

TEST_CASE("a child process tests new code before the program restarts with it", "[restart]") {
  const TemporaryFolder folder;
  const auto script = [&](std::string_view text) {
    const fs::path file = folder.path() / "program";
    write_file(file, text);
    fs::permissions(file, fs::perms::owner_all);
    return file;
  };
  CHECK(why_not_loadable(script("#!/bin/sh\n[ \"$*\" = --list ]\n"), {}).empty());
  CHECK(mentions(why_not_loadable(script("#!/bin/sh\necho 'no step defines the function f'; exit 2\n"), {}),
                 {"no step defines the function f"}));
  CHECK(mentions(why_not_loadable(script("#!/bin/sh\nkill -SEGV $$\n"), {}), {"segmentation fault"}));

  CommandLine line;
  line.implementations = Implementations::parse(folder.path().string());
  const std::string wanted = "--list --implementations=" + folder.path().string();
  CHECK(why_not_loadable(script("#!/bin/sh\n[ \"$*\" = '" + wanted + "' ]\n"), line).empty());
}

TEST_CASE("the running program knows its own file", "[restart]") {
  CHECK(fs::is_regular_file(this_program()));
  CHECK(this_program().is_absolute());
}

TEST_CASE("a setting's text reads back as the same value", "[restart]") {
  Settings settings({{.name = "flag", .fallback = false},
                     {.name = "number", .fallback = 3, .low = -10, .high = 10},
                     {.name = "real", .fallback = 0.5, .low = -1, .high = 1},
                     {.name = "choice", .fallback = std::string("a"), .choices = {"a", "b"}},
                     {.name = "colour", .fallback = Colour(0), .low = 0, .high = 1}});
  const std::pair<const char*, SettingValue> rows[] = {{"flag", true},
                                                       {"number", -7},
                                                       {"real", 1.0 / 3},
                                                       {"real", -1e-300},
                                                       {"choice", std::string("b")},
                                                       {"colour", Colour(1.0 / 3, 1e-300, 1)}};
  for (const auto& [name, value] : rows) {
    settings.set(name, setting_text(value));
    CHECK(settings.value(name) == value);
  }
}
