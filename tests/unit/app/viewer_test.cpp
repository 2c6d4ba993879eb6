#include "app/window/viewer.hpp"

#include "app/picture.hpp"
#include "app/window/presenter.hpp"
#include "catch.hpp"
#include "fake_step.hpp"
#include "gl/context.hpp"
#include "image/colour.hpp"

namespace {

using namespace atelier;
using test::error_of;
using test::mentions;

CommandLine plain_line() {
  CommandLine line;
  line.picture.size = {48, 32};
  return line;
}

/// The frame's settings with which a window shows exactly what --out draws.
const std::vector<std::pair<std::string, std::string>> as_written = {{"frame.format", "32f"}, {"frame.samples", "1"}};

/// A viewer over the fake step, on a context without a window.
struct Room {
  TemporaryFolder folder;
  std::unique_ptr<HeadlessContext> context = make_headless_context();
  test::FakeStep step;
  std::optional<Viewer> viewer;
  explicit Room(const CommandLine& line = plain_line()) {
    test::write_fake_shaders(folder.path());
    viewer.emplace(step, context->gl(), implementations(), line);
    viewer->resize({48, 32});
  }
  Implementations implementations() const { return Implementations({{folder.path(), ""}}); }
  Image picture() { return viewer->picture()->read_colour(context->gl()); }

  /// Replaces the shader and makes sure that its time of change is another: a test is faster than some file systems'
  /// clocks.
  void write_shader(std::string_view text) {
    const auto file = folder.path() / test::step_name / "shade.glsl";
    const auto before = std::filesystem::last_write_time(file);
    write_file(file, text);
    std::filesystem::last_write_time(file, before + std::chrono::seconds(1));
  }
};

constexpr const char* green_glsl = "vec3 shade(Surface surface) { return vec3(0.0, 1.0, 0.0); }\n";
constexpr const char* broken_glsl = "vec3 shade(Surface surface) { return colour; }\n";

}  // namespace

TEST_CASE("a viewer draws only if something has changed", "[viewer]") {
  Room room;
  Viewer& viewer = *room.viewer;
  REQUIRE(viewer.draw());
  CHECK_FALSE(viewer.draw());
  CHECK(room.step.draws == 1);
  REQUIRE_FALSE(viewer.cost().groups.empty());
  CHECK(viewer.cost().groups[0] == GlGroup{.depth = 0, .name = "frame", .passes = 2, .draws = 1, .triangles = 12});

  const struct {
    const char* name;
    void (*change)(Viewer&);
    int loads;
  } rows[] = {
      {"turn",
       [](Viewer& v) {
         v.turn({10, 5}, 32);
       },
       0},
      {"pan",
       [](Viewer& v) {
         v.pan({1, 2}, 32);
       },
       0},
      {"dolly", [](Viewer& v) { v.dolly(1); }, 0},
      {"reset of the camera", [](Viewer& v) { v.reset_camera(); }, 0},
      {"output", [](Viewer& v) { v.choose_output("normal"); }, 0},
      {"size",
       [](Viewer& v) {
         v.resize({20, 10});
       },
       0},
      {"setting", [](Viewer& v) { v.set("tint.brightness", 0.25); }, 1},
      {"reset of the settings", [](Viewer& v) { v.reset_settings(); }, 1},
      {"scene", [](Viewer& v) { v.choose_scene("ring"); }, 1},
      {"clock",
       [](Viewer& v) {
         v.play(true);
         v.advance(0.5);
       },
       0},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    const int loads = room.step.loads, draws = room.step.draws;
    row.change(viewer);
    CHECK(viewer.draw());
    CHECK_FALSE(viewer.draw());
    CHECK(room.step.loads == loads + row.loads);
    CHECK(room.step.draws == draws + 1);
    CHECK_FALSE(viewer.trouble.any());
  }
  CHECK(room.step.last_time == 0.5);
  viewer.resize({20, 10});  // the size that it has
  viewer.play(false);
  viewer.advance(0.5);
  CHECK_FALSE(viewer.draw());
}

TEST_CASE("a viewer shows what --out draws, to the bit", "[viewer]") {
  CommandLine line = plain_line();
  line.picture.scene = "ring";
  line.picture.camera.eye = glm::dvec3(0.1, 0.7, 2);
  line.settings = as_written;
  line.settings.emplace_back("tint.colour", "blue");
  Room room(line);
  REQUIRE(room.viewer->draw());
  const Image seen = room.picture();

  Case picture = line.picture;
  picture.settings["tint.colour"] = std::string("blue");
  test::FakeStep other;
  Painter painter(other, *room.context, room.implementations());
  CHECK(painter.paint(picture) == seen);
}

TEST_CASE("a viewer draws 8 bits and 4 samples by default, and data as floats", "[viewer]") {
  Room room;
  Viewer& viewer = *room.viewer;
  const auto spec_of = [&] {
    viewer.draw();
    return viewer.picture()->spec();
  };
  const TargetSpec own{.width = 48, .height = 32, .colour = ColourFormat::srgb8, .samples = 4};
  CHECK(spec_of() == own);
  const TargetSpec exact{.width = 48, .height = 32};
  viewer.choose_output("normal");
  CHECK(spec_of() == exact);
  viewer.choose_output("colour");
  viewer.set("frame.format", std::string("32f"));
  viewer.set("frame.samples", std::string("1"));
  CHECK(spec_of() == exact);
  CHECK(viewer.command_line(plain_line()).settings == as_written);  // a restart keeps what was chosen
  viewer.reset_settings();
  CHECK(spec_of() == own);
  CHECK(viewer.command_line(plain_line()).settings.empty());
  viewer.set("frame.supersampling", 4);  // of written pictures
  CHECK(spec_of() == own);
}

TEST_CASE("a viewer's picture is that of --out with the window's settings", "[viewer]") {
  Room room;
  REQUIRE(room.viewer->draw());
  // As the presenter reads it: from the texture, which the samples have been brought into.
  const Target screen(room.context->gl(), {.width = 48, .height = 32, .depth = DepthFormat::none});
  Presenter presenter(room.context->gl());
  screen.bind(room.context->gl());
  presenter.draw(*room.viewer->picture(), Encoding::linear, {{0, 0}, {48, 32}});
  const Image shown = read_framebuffer(room.context->gl(), {48, 32});

  Case picture = plain_line().picture;
  picture.settings["frame.format"] = std::string("8");
  picture.settings["frame.samples"] = std::string("4");
  test::FakeStep other;
  Painter painter(other, *room.context, room.implementations());
  const Image expected = srgb_encode(painter.paint(picture));
  for (std::size_t i = 0; i < shown.pixels().size(); ++i) {
    const Rgba &a = shown.pixels()[i], &b = expected.pixels()[i];
    REQUIRE(std::lround(a.r * 255) == std::lround(b.r * 255));  // code for code, as the screen shows them
    REQUIRE(std::lround(a.b * 255) == std::lround(b.b * 255));
  }
}

TEST_CASE("the camera rotates, and a reset restores the scene's camera", "[viewer]") {
  Room room;
  Viewer& viewer = *room.viewer;
  REQUIRE(viewer.draw());
  const Image start = room.picture();
  viewer.turn({16, 0}, 32);  // half the height: a quarter turn
  REQUIRE(viewer.draw());
  CHECK_FALSE(room.picture() == start);
  const glm::dvec3 eye = viewer.camera().eye;       // from (1, 1.5, 3), the camera goes to the left of the picture
  CHECK(glm::distance(eye, {-3, 1.5, 1}) < 1e-12);  // rounding of a few products of numbers about 3
  viewer.reset_camera();
  REQUIRE(viewer.draw());
  CHECK(room.picture() == start);
}

TEST_CASE("where a scene is walked through, the controls move a visitor", "[viewer]") {
  Room room;
  room.step.walked = true;
  Viewer& viewer = *room.viewer;
  REQUIRE(viewer.draw());
  const double x = viewer.camera().eye.x;
  viewer.arrow({0, 1});
  CHECK(viewer.camera().eye.x > x);
  CHECK_FALSE(viewer.moving());
  viewer.arrow({-1, 0});  // which is a jump here
  REQUIRE(viewer.moving());
  const double before = viewer.camera().eye.x;
  viewer.advance(0.5);
  CHECK(viewer.camera().eye.x == before + 0.5);
  CHECK_FALSE(viewer.moving());
  REQUIRE(viewer.draw());
  const int loads = room.step.loads;
  viewer.dolly(100);  // beyond x = 10
  CHECK(viewer.settings().choice("tint.colour") == "blue");
  REQUIRE(viewer.draw());
  CHECK(room.step.loads == loads + 1);
  CHECK(viewer.camera().eye.x > 10);  // the new scene keeps the visitor's place
  viewer.reset_camera();
  CHECK(viewer.camera().eye.x == x);
}

TEST_CASE("a frame that has left something for later is followed by another", "[viewer]") {
  Room room;
  Viewer& viewer = *room.viewer;
  room.step.unfinished = true;
  REQUIRE(viewer.draw());
  CHECK(viewer.moving());
  room.step.unfinished = false;
  REQUIRE(viewer.draw());
  CHECK_FALSE(viewer.moving());
  CHECK_FALSE(viewer.draw());
}

TEST_CASE("a new setting keeps the chosen camera, a new scene has its own", "[viewer]") {
  CommandLine line = plain_line();
  line.picture.camera.eye = glm::dvec3(0, 0, 9);
  Room room(line);
  Viewer& viewer = *room.viewer;
  REQUIRE(viewer.draw());
  CHECK(viewer.camera().eye == glm::dvec3(0, 0, 9));
  viewer.dolly(2);
  const glm::dvec3 nearer = viewer.camera().eye;
  viewer.set("tint.brightness", 0.25);
  REQUIRE(viewer.draw());
  CHECK(viewer.camera().eye == nearer);
  viewer.choose_scene("ring");
  REQUIRE(viewer.draw());
  CHECK(viewer.camera().eye == glm::dvec3(0, 0, 3));
}

TEST_CASE("an exception in a student's code is shown, and the last good picture stays", "[viewer]") {
  Room room;
  Viewer& viewer = *room.viewer;
  REQUIRE(viewer.draw());
  const Image good = room.picture();

  const struct {
    const char* name;
    void (*thrower)();
    const char* words;
  } rows[] = {
      {"an error", [] { throw Error("the light is out"); }, "the light is out"},
      {"a standard exception", [] { throw std::out_of_range("vector::at"); }, "vector::at"},
      {"a number", [] { throw 3; }, "not a std::exception"},
      {"nothing to say", [] { throw std::runtime_error(""); }, "without a message"},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    room.step.on_draw = row.thrower;
    viewer.turn({3, 3}, 32);
    CHECK_FALSE(viewer.draw());
    CHECK(mentions(viewer.trouble.drawing, {row.words}));
    CHECK(room.picture() == good);
    CHECK_FALSE(viewer.draw());  // and it is not tried again and again
  }
  room.step.on_draw = nullptr;
  CHECK(viewer.retry());
  CHECK(viewer.draw());
  CHECK_FALSE(viewer.trouble.any());
  CHECK_FALSE(viewer.retry());
}

TEST_CASE("a scene that cannot be loaded is reported, and another can be chosen", "[viewer]") {
  Room room;
  Viewer& viewer = *room.viewer;
  REQUIRE(viewer.draw());
  viewer.choose_scene("missing.obj");
  CHECK_FALSE(viewer.draw());
  CHECK(mentions(viewer.trouble.drawing, {"missing.obj"}));
  REQUIRE(viewer.picture());
  viewer.choose_scene("ring");
  CHECK(viewer.draw());
  CHECK_FALSE(viewer.trouble.any());
}

TEST_CASE("a scene whose loading failed is loaded again", "[viewer]") {
  Room room;
  Viewer& viewer = *room.viewer;
  room.step.on_load = [] { throw Error("upload_mesh: no buffer"); };
  CHECK_FALSE(viewer.draw());
  CHECK(mentions(viewer.trouble.drawing, {"upload_mesh"}));
  CHECK(room.step.draws == 0);  // there is nothing to draw
  room.step.on_load = nullptr;
  CHECK(viewer.retry());
  CHECK(viewer.draw());
  CHECK(room.step.loads == 2);
  CHECK(viewer.camera().eye == glm::dvec3(1, 1.5, 3));  // the scene's own, which the first try did not bring
}

TEST_CASE("a changed shader is used; a broken one keeps the last picture", "[viewer]") {
  Room room;
  Viewer& viewer = *room.viewer;
  REQUIRE(viewer.draw());
  CHECK_FALSE(viewer.reload_shaders());

  room.write_shader(green_glsl);
  CHECK(viewer.reload_shaders());
  REQUIRE(viewer.draw());
  CHECK(room.picture().at(24, 16) == Rgba{0, 1, 0, 1});

  room.write_shader(broken_glsl);
  CHECK(viewer.reload_shaders());  // there is a message to show
  CHECK(mentions(viewer.trouble.shaders, {"shade.glsl:1", "colour"}));
  viewer.turn({1, 0}, 32);
  CHECK(viewer.draw());  // by the last good program
  CHECK(room.picture().at(24, 16) == Rgba{0, 1, 0, 1});

  room.write_shader(test::shade_glsl);
  CHECK(viewer.reload_shaders());
  CHECK(viewer.trouble.shaders.empty());
  REQUIRE(viewer.draw());
  CHECK(room.picture().at(24, 16).g < 0.5f);
}

TEST_CASE("NaN is visible in every format", "[viewer]") {
  const char* const shaders[] = {
      "uniform vec3 u_tint;\nvec3 shade(Surface surface) { return (u_tint - u_tint) / (u_tint - u_tint); }\n",
      "uniform vec3 u_tint;\nvec3 shade(Surface surface) { return vec3(0.5, 1.0 / (u_tint.x - u_tint.x), 0.5); }\n"};
  for (const char* shader : shaders)
    for (const char* format : {"8", "16f", "32f"})
      for (const char* samples : {"1", "4"}) {
        INFO(shader << format << ", samples " << samples);
        CommandLine line = plain_line();
        line.settings = {{"frame.format", format}, {"frame.samples", samples}};
        Room room(line);
        room.write_shader(shader);
        REQUIRE(room.viewer->draw());
        const Target screen(room.context->gl(), {.width = 48, .height = 32, .depth = DepthFormat::none});
        Presenter presenter(room.context->gl());
        screen.bind(room.context->gl());
        presenter.draw(*room.viewer->picture(), Encoding::linear, {{0, 0}, {48, 32}});
        const Rgba shown = read_framebuffer(room.context->gl(), {48, 32}).at(24, 16);
        CHECK(shown.r == Approx(1).margin(1e-6));  // stored magenta is encoded again: the roundings of a power near 1
        CHECK(shown.g == 0);
        CHECK(shown.b == Approx(1).margin(1e-6));
      }
}

TEST_CASE("a shader that is broken at startup can be fixed", "[viewer]") {
  Room room;
  Viewer& viewer = *room.viewer;
  room.write_shader(broken_glsl);
  CHECK_FALSE(viewer.draw());
  CHECK(mentions(viewer.trouble.drawing, {"shade.glsl:1"}));
  CHECK(viewer.picture() == nullptr);
  room.write_shader(green_glsl);
  CHECK(viewer.retry());
  CHECK(viewer.draw());
  CHECK(room.picture().at(24, 16) == Rgba{0, 1, 0, 1});
}

TEST_CASE("a typing error on the command line is refused before a window opens", "[viewer]") {
  const struct {
    const char* name;
    void (*spoil)(CommandLine&);
    std::initializer_list<std::string_view> answer;
  } rows[] = {
      {"scene", [](CommandLine& l) { l.picture.scene = "rink"; }, {"--scene rink", "ring"}},
      {"output", [](CommandLine& l) { l.picture.output = "norml"; }, {"--output norml", "normal"}},
      {"setting",
       [](CommandLine& l) {
         l.settings = {{"tint.color", "red"}};
       },
       {"tint.color", "tint.colour"}},
      {"value",
       [](CommandLine& l) {
         l.settings = {{"segments", "2"}};
       },
       {"segments", "3..4096"}},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    CommandLine line = plain_line();
    row.spoil(line);
    CHECK(mentions(error_of([&] { Room room(line); }), row.answer));
  }
}

TEST_CASE("a view can be opened again from its command line", "[viewer]") {
  Image seen;
  CommandLine line;
  {
    Room room;  // ended before the next begins: a thread has one context
    Viewer& viewer = *room.viewer;
    REQUIRE(viewer.draw());
    CHECK(viewer.command_line(plain_line()).settings.empty());
    CHECK_FALSE(viewer.command_line(plain_line()).picture.camera.eye);

    viewer.choose_scene("ring");
    viewer.choose_output("normal");
    viewer.set("tint.brightness", 0.1);
    viewer.set("draw.wireframe", true);
    REQUIRE(viewer.draw());
    viewer.turn({7, 3}, 32);
    viewer.pan({2, 1}, 32);
    REQUIRE(viewer.draw());
    seen = room.picture();
    line = viewer.command_line(plain_line());
  }
  Room again(line);
  REQUIRE(again.viewer->draw());
  CHECK(again.picture() == seen);
}

TEST_CASE("sizes out of range are clamped", "[viewer]") {
  Room room;
  room.viewer->resize({0, -5});
  REQUIRE(room.viewer->draw());
  CHECK(room.picture().width() == 1);
  CHECK(room.picture().height() == 1);
}

TEST_CASE("the presenter encodes once, clamps, and marks NaN", "[presenter]") {
  const auto context = make_headless_context();
  Gl& gl = context->gl();
  const Target source(gl, {.width = 1, .height = 1, .depth = DepthFormat::none});
  const Target screen(gl, {.width = 3, .height = 3, .depth = DepthFormat::none});
  Presenter presenter(gl);
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();

  const struct {
    const char* name;
    glm::vec3 colour;
    Encoding encoding;
    glm::vec3 shown;
  } rows[] = {
      {"black", {0, 0, 0}, Encoding::linear, {0, 0, 0}},
      {"linear light",
       {0.5f, 0.001f, 0.2f},
       Encoding::linear,
       {srgb_encode(0.5f), srgb_encode(0.001f), srgb_encode(0.2f)}},
      {"encoded already", {0.5f, 0.001f, 0.2f}, Encoding::srgb, {0.5f, 0.001f, 0.2f}},
      {"data", {0.25f, 0.75f, 1}, Encoding::data, {0.25f, 0.75f, 1}},
      {"above one and below zero", {7, -1, 1}, Encoding::linear, {1, 0, 1}},
      {"no number", {nan, 0, 0}, Encoding::linear, {1, 0, 1}},
      {"infinite", {0, 0, infinity}, Encoding::data, {1, 0, 1}},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    source.bind(gl);
    const float colour[4] = {row.colour.r, row.colour.g, row.colour.b, 1};
    gl.ClearBufferfv(GL_COLOR, 0, colour);
    screen.bind(gl);
    gl.ClearColor(0, 0, 0, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.restart_counts();
    presenter.draw(source, row.encoding, {{0, 0}, {2, 3}});
    CHECK(gl.groups() ==
          std::vector<GlGroup>{{.depth = 0, .name = "picture to window", .passes = 1, .draws = 1, .triangles = 1}});
    const Image shown = read_framebuffer(gl, {3, 3});
    // A driver's pow is good to some 1e-4: a tenth of a step of 8 bits.
    CHECK(shown.at(0, 0).r == Approx(row.shown.r).margin(4e-4));
    CHECK(shown.at(1, 2).g == Approx(row.shown.g).margin(4e-4));
    CHECK(shown.at(1, 1).b == Approx(row.shown.b).margin(4e-4));
    CHECK(shown.at(2, 1) == Rgba{0, 0, 0, 1});  // beside its area nothing is drawn
  }
}

TEST_CASE("the presenter does not encode sRGB codes again", "[presenter]") {
  const auto context = make_headless_context();
  Gl& gl = context->gl();
  const Target source(gl, {.width = 1, .height = 1, .colour = ColourFormat::srgb8, .depth = DepthFormat::none});
  // A window's framebuffer may be one that encodes by itself: it must not.
  const Target plain(gl, {.width = 1, .height = 1, .colour = ColourFormat::rgba8, .depth = DepthFormat::none}),
      encoding(gl, source.spec());
  Presenter presenter(gl);
  for (int code = 0; code < 256; ++code) {
    const float light = linear_of_code(std::uint8_t(code)), colour[4] = {light, light, light, 1};
    for (const Target* screen : {&plain, &encoding}) {
      INFO("code " << code << " on " << to_string(screen->spec()));
      source.bind(gl);
      gl.ClearBufferfv(GL_COLOR, 0, colour);
      screen->bind(gl);
      presenter.draw(source, Encoding::linear, {{0, 0}, {1, 1}});
      REQUIRE(std::lround(read_framebuffer(gl, {1, 1}).at(0, 0).g * 255) == code);
    }
  }
}
