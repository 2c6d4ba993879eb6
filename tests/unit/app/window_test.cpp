// The window itself, on a display that exists only in memory.
#include <cstdlib>

#include "app/picture.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "catch.hpp"
#include "fake_step.hpp"
#include "gl/context.hpp"
#include "image_io/image_io.hpp"

namespace {

using namespace atelier;
using test::mentions;

const std::string program = std::string(ATELIER_TEST_PROGRAMS) + "/window_probe";

/// Of the environment only what starting a program takes: what the tester's desktop sets must not matter.
std::map<std::string, std::string> bare_environment() {
  std::map<std::string, std::string> environment;
  for (const char* name : {"PATH", "HOME", "TMPDIR", "LD_LIBRARY_PATH"})
    if (const char* value = std::getenv(name)) environment[name] = value;
  environment["LIBGL_ALWAYS_SOFTWARE"] = "1";
  // Under AddressSanitizer: what GLX leaks is counted when its modules are unloaded already, and cannot be told apart.
  environment["ASAN_OPTIONS"] = "detect_leaks=0";
  return environment;
}

bool have_virtual_display() {
  const Finished found = run_process({.arguments = {"sh", "-c", "command -v xvfb-run && command -v Xvfb"}});
  return found.ok();
}

Finished run_in_window(std::map<std::string, std::string> environment, std::vector<std::string> arguments) {
  std::vector<std::string> words = {"xvfb-run", "-a", "-s", "-screen 0 1280x800x24", program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_process(
      {.arguments = words, .environment = std::move(environment), .time_limit = std::chrono::seconds(90)});
}

/// A folder with the fake step's shaders, and something that stands for its library.
struct Home {
  TemporaryFolder folder;
  std::string implementations = (folder.path() / "implementations").string();
  std::filesystem::path library = folder.path() / "implementations" / test::step_name / "libstep.so";
  Home() {
    test::write_fake_shaders(implementations);
    write_file(library, std::string_view("a library"));
  }
};

}  // namespace

TEST_CASE("without a display the window says what to do instead", "[window]") {
  const Home home;
  const Finished finished = run_process(
      {.arguments = {program, "--implementations", home.implementations}, .environment = bare_environment()});
  CHECK(finished.exit_status == exit_usage);
  INFO(finished.output);
  CHECK(mentions(finished.output, {"error: no window can be opened", "--out FILE.png"}));
}

TEST_CASE("a window opens, shows what --out draws, and quits", "[window]") {
  if (!have_virtual_display()) SKIP_TEST("xvfb-run is not installed (Debian: xvfb)");
  const Home home;
  const auto file = home.folder.path() / "window.png";
  auto environment = bare_environment();
  environment["ATELIER_WINDOW_FRAMES"] = "4";
  environment["ATELIER_WINDOW_SAVE"] = file.string();
  const Finished finished =
      run_in_window(environment, {"--implementations", home.implementations, "--scene", "ring", "--size", "320x240"});
  INFO(finished.output);
  REQUIRE(finished.exit_status == exit_ok);

  const Image window = read_image(file, Encoding::srgb);
  REQUIRE(window.width() >= 320);  // the panel stands to the right, where there is one
  REQUIRE(window.height() == 240);

  const auto context = make_headless_context();  // first, because the step's objects go before it does
  test::FakeStep step;
  Painter painter(step, *context, Implementations({{home.implementations, ""}}));
  Case picture;
  picture.scene = "ring";
  picture.size = {320, 240};
  picture.settings = {{"frame.format", std::string("8")}, {"frame.samples", std::string("4")}};  // a window's defaults
  const Image expected = srgb_encode(painter.paint(picture));
  int different = 0;
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 320; ++x) {
      const Rgba a = window.at(x, y), b = expected.at(x, y);
      // Half a step of 8 bits by rounding and a little by the shader's pow.
      const float limit = 0.6f / 255;
      different += std::abs(a.r - b.r) > limit || std::abs(a.g - b.g) > limit || std::abs(a.b - b.b) > limit;
    }
  // The driver behind a window may place edges by another pixel; the rest must agree.
  CHECK(different < 320 * 240 / 200);
}

TEST_CASE("a window restarts when the step's library has been rebuilt", "[window]") {
  if (!have_virtual_display()) SKIP_TEST("xvfb-run is not installed (Debian: xvfb)");
  const Home home;
  const auto starts = home.folder.path() / "starts.txt";
  auto environment = bare_environment();
  environment["FAKE_STARTS"] = starts.string();
  environment["FAKE_TOUCH"] = home.library.string();
  const Finished finished = run_in_window(
      environment, {"--implementations", home.implementations, "--size", "64x48", "--set", "tint.colour=blue"});
  INFO(finished.output);
  CHECK(finished.exit_status == exit_ok);
  const std::string lines = read_file(starts);
  INFO(lines);
  CHECK(std::count(lines.begin(), lines.end(), '\n') == 2);
  const std::string second = lines.substr(lines.find('\n'));
  CHECK(mentions(second, {"--scene=box", "--size=64x48", "--set=tint.colour=blue", "--implementations="}));
}

TEST_CASE("invalid environment variables are refused", "[window]") {
  const Home home;
  const std::pair<const char*, const char*> rows[] = {{"ATELIER_WINDOW_FRAMES", "0"},
                                                      {"ATELIER_WINDOW_FRAMES", "many"},
                                                      {"ATELIER_WINDOW_FRAMES", "3x"},
                                                      {"ATELIER_WINDOW_PLACE", "7"},
                                                      {"ATELIER_WINDOW_PLACE", "a,b"}};
  for (const auto& [name, value] : rows) {
    INFO(name << "=" << value);
    auto environment = bare_environment();
    environment[name] = value;
    const Finished finished =
        run_process({.arguments = {program, "--implementations", home.implementations}, .environment = environment});
    CHECK(finished.exit_status == exit_usage);
    CHECK(mentions(finished.output, {name, value}));
  }
}
