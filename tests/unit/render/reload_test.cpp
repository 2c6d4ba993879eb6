#include "catch.hpp"
#include "pieces.hpp"

namespace {

using namespace atelier;
using namespace atelier::test;

constexpr const char* file = "00-fake/colour.glsl";

std::string shade(const std::string& colour) {
  return "vec3 shade(Surface surface) { return " + colour + "; }\n";
}

/// The triangle, shaded by a file that a test can change.
struct ReloadStudio {
  Shaders shaders;
  std::unique_ptr<HeadlessContext> context = make_headless_context();
  Scene scene = triangle_scene();
  std::unique_ptr<Renderer> renderer;
  ReloadStudio() {
    shaders.write(file, shade("vec3(1.0, 0.0, 0.0)"));
    auto feature = std::make_unique<Piece>();
    feature->filled = {{Slot::shade, {file, "shade"}}};
    std::vector<std::unique_ptr<Feature>> features;
    features.push_back(std::move(feature));
    renderer =
        std::make_unique<Renderer>(context->gl(), shaders.implementations(), fake_transforms(), std::move(features));
    renderer->prepare(scene);
  }
  Rgba draw() {
    const Target target(context->gl(), {.width = 32, .height = 24});
    renderer->render({.camera = scene.camera}, target);
    return target.read_colour(context->gl()).at(10, 18);
  }
};

}  // namespace

TEST_CASE("an edited shader is used without a restart", "[reload]") {
  ReloadStudio studio;
  CHECK(studio.renderer->reload_changed_shaders().empty());  // nothing is built yet
  CHECK(studio.draw() == Rgba{1, 0, 0, 1});
  const auto linked = studio.context->gl().counts().programs_linked;
  CHECK(studio.renderer->reload_changed_shaders().empty());
  CHECK(studio.context->gl().counts().programs_linked == linked);  // nothing has changed, nothing is built

  studio.shaders.write(file, shade("vec3(0.0, 1.0, 0.0)"));
  CHECK(studio.draw() == Rgba{1, 0, 0, 1});  // only when it is asked to look
  CHECK(studio.renderer->reload_changed_shaders().empty());
  CHECK(studio.draw() == Rgba{0, 1, 0, 1});
}

TEST_CASE("a shader cannot include files outside its folders", "[reload]") {
  const TemporaryFolder folder;
  const auto secret = folder.path() / "secret.glsl";
  write_file(secret, "vec3 shade(Surface surface) { return vec3(1.0); }\n");
  for (const std::string& name : {secret.string(), "../" + folder.path().filename().string() + "/secret.glsl",
                                  std::string("00-fake/../../secret.glsl")}) {
    INFO(name);
    ReloadStudio studio;
    studio.shaders.write(file, "#include \"" + name + "\"\n");
    CHECK(mentions(error_of([&] { studio.draw(); }), {name}));
  }
}

TEST_CASE("a broken shader leaves the last good one in place", "[reload]") {
  ReloadStudio studio;
  CHECK(studio.draw() == Rgba{1, 0, 0, 1});
  const struct {
    const char* name;
    std::string text;
    std::initializer_list<std::string_view> answer;
  } rows[] = {
      {"unknown name", "\n\n" + shade("colur"), {"colour.glsl:3", "colur"}},
      {"missing include", "#include \"gone.glsl\"\n" + shade("vec3(0.0)"), {"gone.glsl"}},
      {"a function that is gone", "vec3 shaded(Surface surface) { return vec3(0.0); }\n", {"shade"}},
      {"empty", "", {"shade"}},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    studio.shaders.write(file, row.text);
    const std::string words = studio.renderer->reload_changed_shaders();
    INFO(words);
    CHECK(mentions(words, row.answer));
    CHECK(studio.draw() == Rgba{1, 0, 0, 1});
    CHECK_FALSE(studio.renderer->reload_changed_shaders().empty());  // as long as it is broken
  }
  studio.shaders.write(file, shade("vec3(0.0, 0.0, 1.0)"));
  CHECK(studio.renderer->reload_changed_shaders().empty());
  CHECK(studio.draw() == Rgba{0, 0, 1, 1});
}

TEST_CASE("a file included by another is watched too", "[reload]") {
  ReloadStudio studio;
  studio.shaders.write("00-fake/palette.glsl", "const vec3 paint = vec3(0.5, 0.0, 0.0);\n");
  studio.shaders.write(file, "#include \"00-fake/palette.glsl\"\n" + shade("paint"));
  CHECK(studio.draw() == Rgba{0.5f, 0, 0, 1});
  studio.shaders.write("00-fake/palette.glsl", "const vec3 paint = vec3(0.0, 0.5, 0.0);\n");
  CHECK(studio.renderer->reload_changed_shaders().empty());
  CHECK(studio.draw() == Rgba{0, 0.5f, 0, 1});
}

TEST_CASE("a deleted file leaves the program that was built from it", "[reload]") {
  ReloadStudio studio;
  CHECK(studio.draw() == Rgba{1, 0, 0, 1});
  std::filesystem::remove(studio.shaders.folder.path() / file);
  CHECK(studio.renderer->reload_changed_shaders().empty());  // editors delete before they write
  CHECK(studio.draw() == Rgba{1, 0, 0, 1});
}
