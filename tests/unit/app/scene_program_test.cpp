#include "app/scene_program.hpp"

#include "app/picture.hpp"
#include "catch.hpp"
#include "fake_step.hpp"
#include "gl/context.hpp"

namespace {

using namespace atelier;
using test::error_of;
using test::mentions;

Case with(const std::string& setting, const SettingValue& value) {
  Case picture;
  picture.size = {48, 32};
  picture.settings[setting] = value;
  return picture;
}

/// How many pixels show what is behind everything.
std::ptrdiff_t background_pixels(const Image& image) {
  return std::count(image.pixels().begin(), image.pixels().end(), Rgba{0.02f, 0.03f, 0.05f, 1});
}

double mean_difference(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i)
    sum += std::abs(a.pixels()[i].r - b.pixels()[i].r) + std::abs(a.pixels()[i].g - b.pixels()[i].g);
  return sum / double(a.pixels().size());
}

}  // namespace

TEST_CASE("an unknown scene names the known ones, the nearest, and the kinds of files") {
  const auto unknown = [](const std::string& name) {
    return error_of([&] { make_scene(test::fake_scenes(), name, Settings(std::vector<SettingSpec>())); });
  };
  const std::string known = test::fake_scenes().front().name;
  CHECK(mentions(unknown("nothing like it"), {"'nothing like it'", known}));
  CHECK_FALSE(mentions(unknown("nothing like it"), {"did you mean"}));
  CHECK(mentions(unknown(known + "x"), {"did you mean '" + known + "'?"}));
  CHECK(mentions(unknown("model.fbx"), {".gltf, .glb and .obj"}));
}

TEST_CASE("a scene program offers the renderer's intermediates beside its own outputs", "[scene_program]") {
  const test::FakeStep step;
  std::vector<std::string> names;
  for (const OutputSpec& output : step.description().outputs) names.push_back(output.name);
  CHECK(names == std::vector<std::string>{"colour", "position", "depth", "texcoord", "normal"});
}

TEST_CASE("a scene program has the settings of the frame behind its own", "[scene_program]") {
  const test::FakeStep step;
  std::vector<std::string> names;
  for (const SettingSpec& spec : step.description().settings) names.push_back(spec.name);
  REQUIRE(names.size() > 5);
  CHECK(
      std::vector<std::string>(names.end() - 5, names.end()) ==
      std::vector<std::string>{"tint.glow", "draw.constants", "frame.format", "frame.samples", "frame.supersampling"});
}

TEST_CASE("the view settings work", "[scene_program]") {
  const TemporaryFolder folder;
  test::write_fake_shaders(folder.path());
  const auto context = make_headless_context();
  test::FakeStep step;
  Painter painter(step, *context, Implementations({{folder.path(), ""}}));
  const Image plain = painter.paint(with("draw.wireframe", false));

  SECTION("edges instead of faces") {
    const Image edges = painter.paint(with("draw.wireframe", true));
    // Through the faces one sees the background: the box covers a third of the picture, its edges a fraction of that.
    CHECK(background_pixels(edges) > background_pixels(plain) + 48 * 32 / 10);
    CHECK(background_pixels(edges) < 48 * 32);
  }
  SECTION("camera-relative drawing shows the same") {
    // Positions round elsewhere, in the last bits of floats of size 1: a few edge pixels at most.
    CHECK(mean_difference(plain, painter.paint(with("world.camera_relative", true))) < 1e-3);
  }
  SECTION("depth formats change no picture") {
    for (const char* format : {"16", "32f", "32f-reversed"}) {
      INFO(format);
      if (std::string(format) == "32f-reversed" && !context->gl().ClipControl.call) continue;
      CHECK(painter.paint(with("depth.format", std::string(format))) == plain);
    }
  }
  SECTION("the target has the depth format of the setting") {
    Settings settings(step.description().settings);
    CHECK(step.depth_format(settings) == DepthFormat::depth24);
    settings.set("depth.format", "16");
    CHECK(step.depth_format(settings) == DepthFormat::depth16);
    settings.set("depth.format", "32f-reversed");
    CHECK(step.depth_format(settings) == DepthFormat::depth32f);
  }
}

TEST_CASE("a program without view settings draws with the defaults", "[scene_program]") {
  const SceneProgram program(test::bare_step());
  CHECK(program.depth_format(Settings()) == DepthFormat::depth24);
}

TEST_CASE("a target has a stencil buffer only if a feature draws views inside views", "[scene_program]") {
  struct Portals : Feature {
    bool there = false;
    void prepare(Gl&, const Scene& scene) override { there = scene.name == "box"; }
    bool needs_stencil(const Scene&) const override { return there; }
    Need need(const Scene&, const View&, const Node&) const override { return {}; }
  };
  const TemporaryFolder folder;
  test::write_fake_shaders(folder.path());
  const auto context = make_headless_context();
  SceneStep parts = test::bare_step(view_settings());
  parts.scenes = {{"box", [](const Settings&) { return Scene{.name = "box"}; }},
                  {"other", [](const Settings&) { return Scene{.name = "other"}; }}};
  parts.features = [](FeatureList& list) { list.add<Portals>(); };
  SceneProgram program(std::move(parts));
  program.open(context->gl(), Implementations({{folder.path(), ""}}));
  const struct {
    const char* scene;
    const char* format;
    DepthFormat expected;
  } rows[] = {{"box", "16", DepthFormat::depth24_stencil8},   {"box", "24", DepthFormat::depth24_stencil8},
              {"box", "32f", DepthFormat::depth32f_stencil8}, {"other", "16", DepthFormat::depth16},
              {"other", "24", DepthFormat::depth24},          {"box", "32f-reversed", DepthFormat::depth32f_stencil8}};
  for (const auto& row : rows) {
    INFO(row.scene << ", " << row.format);
    Settings settings(program.description().settings);
    settings.set("depth.format", row.format);
    program.load(row.scene, settings);
    CHECK(program.depth_format(settings) == row.expected);
  }
}

TEST_CASE("a scene is drawn with its own camera", "[scene_program]") {
  const TemporaryFolder folder;
  test::write_fake_shaders(folder.path());
  const auto context = make_headless_context();
  test::FakeStep step;
  step.open(context->gl(), Implementations({{folder.path(), ""}}));
  const Settings settings(step.description().settings);
  step.load("ring", settings);
  CHECK(step.camera().eye == glm::dvec3(0, 0, 3));
  CHECK(mentions(error_of([&] { step.load("hall", settings); }), {"hall"}));
}

TEST_CASE("a walk into another place makes no scene anew, but where there are portals", "[scene_program]") {
  const TemporaryFolder folder;
  test::write_fake_shaders(folder.path());
  const auto context = make_headless_context();
  int made = 0;
  bool portals = false;
  SceneStep walked = test::fake_step();
  walked.scenes = {{"place", [&](const Settings&) {
                      ++made;
                      Scene scene = test::fake_scene("place", make_plane({}));
                      for (Vertex& vertex : scene.meshes[0].vertices)
                        vertex.position = {vertex.position.x, -vertex.position.z, 0};
                      if (portals) scene.portals.push_back({.node = 0, .exit = 0});
                      return scene;
                    }}};
  walked.walk = [](const Walker& walker, const Walking&, double, Settings& settings) {
    settings.set("tint.colour", "blue");
    return walker;
  };
  const auto makes = [&] {
    made = 0;
    SceneProgram program(walked);
    program.open(context->gl(), Implementations({{folder.path(), ""}}));
    Settings settings(program.description().settings);
    program.load("place", settings);
    program.walk({}, {}, 1, settings);
    CHECK(settings.choice("tint.colour") == "blue");
    program.load("place", settings);
    program.load("place", settings);
    return made;
  };
  CHECK(makes() == 1);
  portals = true;
  CHECK(makes() == 2);
}
