// The ground truth on the command line, without OpenGL.
#include "app/truth.hpp"

#include "base/file.hpp"
#include "case/exchange.hpp"
#include "catch.hpp"
#include "fake_step.hpp"

namespace {

using namespace atelier;
using test::error_of;
using test::mentions;

/// The fake step with a truth: an exact sphere in place of whatever the scene is.
SceneStep true_step() {
  SceneStep step = test::fake_step();
  step.features = [](FeatureList&) {};
  step.truth = [](const TruthRequest& request, const Settings& settings, std::optional<Scene>) {
    SceneTruth truth{.scene = make_scene(test::fake_scenes(), request.scene, settings)};
    truth.scene.nodes.clear();
    truth.shapes = {{.surface = oracle::Sphere{1}}};
    truth.shading.surface = [](const oracle::World&, const oracle::SurfacePoint&, const glm::dvec3&) {
      return glm::dvec3(0.75);
    };
    return truth;
  };
  return step;
}

class TrueStep : public SceneProgram {
 public:
  TrueStep() : SceneProgram(true_step()) {}
};

Case small(const std::string& output = "colour") {
  Case picture{.name = "small", .scene = "ring", .size = {16, 12}};
  picture.output = output;
  return picture;
}

/// What a bar writes into a file of its own.
std::string written(bool terminal, double patience_s) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "terminal";
  std::FILE* const file = std::fopen(path.c_str(), "w");
  REQUIRE(file);
  {
    ProgressBar bar(file, terminal, patience_s);
    for (const double done : {0.0, 0.25, 0.2501, 1.0}) bar.show(done);
  }
  std::fclose(file);
  return read_file(path);
}

}  // namespace

TEST_CASE("a program's truth needs no context, and says which outputs it has", "[truth]") {
  const TrueStep step;
  const Image image = trace_case(step, small(), 1);
  CHECK(image.at(8, 6) == Rgba{0.75f, 0.75f, 0.75f, 1});
  CHECK(image.at(0, 0) == Rgba{0.02f, 0.03f, 0.05f, 1});
  // A ball that fills the middle: seen past its rim, a pixel is a mixture.
  const Image smooth = trace_case(step, small(), 4);
  CHECK(smooth.at(8, 6) == image.at(8, 6));
  CHECK(smooth != image);
  CHECK(trace_case(step, small("thing"), 1).at(8, 6).r == 1);  // shape 0 behind no nodes

  Case moved = small("position");
  moved.size = {15, 11};  // the middle pixel's middle lies on the axis
  moved.camera.eye = glm::dvec3(0, 0, 9);
  CHECK(trace_case(step, moved, 1).at(7, 5).b == Approx(1));
  moved.settings["world.camera_relative"] = true;
  CHECK(trace_case(step, moved, 1).at(7, 5).b == Approx(-8));

  Case depth = small("depth");
  const float plain = trace_case(step, depth, 1).at(8, 6).r;
  depth.settings["depth.format"] = std::string("32f-reversed");
  CHECK(trace_case(step, depth, 1).at(8, 6).r == Approx(1 - plain).epsilon(1e-4));
}

TEST_CASE("a request without a ground truth is refused with the reason", "[truth]") {
  CHECK(mentions(error_of([] { trace_case(test::FakeStep(), small(), 1); }), {"00-fake has no ground truth"}));
  const TrueStep step;
  const auto refused = [&](auto&& change) {
    Case picture = small();
    change(picture);
    return error_of([&] { trace_case(step, picture, 1); });
  };
  CHECK(mentions(refused([](Case& c) { c.output = "shadow"; }), {"output 'shadow'", "colour, position, depth"}));
  CHECK(mentions(refused([](Case& c) { c.scene = "hut"; }), {"'hut'", "box, ring"}));
  CHECK(mentions(refused([](Case& c) { c.settings["draw.wireframe"] = true; }), {"draw.wireframe", "no width"}));
  CHECK(mentions(refused([](Case& c) {
                   c.output = "depth";
                   c.settings["camera.fit_depth"] = true;
                 }),
                 {"depth", "camera.fit_depth"}));
  CHECK(mentions(refused([](Case& c) { c.camera.near = 200; }), {"near below far"}));
  CHECK(mentions(refused([](Case& c) { c.settings["segments"] = 2; }), {"segments", "3"}));
}

TEST_CASE("picture cases are answered with files, probes with the reason for refusal", "[truth]") {
  const TemporaryFolder folder;
  write_file(folder.path() / "cases.json",
             std::string_view(R"({"cases": [{"name": "seen", "scene": "box", "size": [8, 8]},
                                            {"name": "twice", "probe": "twice", "inputs": [{"x": 1}]}]})"));
  const TrueStep step;
  trace_cases(step, folder.path() / "cases.json", folder.path(), 2, std::nullopt);
  CHECK(read_pixels(folder.held(), "seen.pixels", {8, 8}).at(4, 4).r == 0.75f);
  CHECK(mentions(read_case_error(folder.held(), "twice.error"), {"probe 'twice'", "only pictures"}));
}

TEST_CASE("the progress bar appears only on terminals, and only after a delay", "[truth]") {
  CHECK(written(false, 0).empty());
  CHECK(written(true, 1e9).empty());
  const std::string bar = written(true, 0);
  CHECK(mentions(bar, {"[" + std::string(10, '#') + std::string(30, '.') + "]  25 %", "100 %"}));
  CHECK(std::count(bar.begin(), bar.end(), '%') == 3);  // the same percent is not written twice
  CHECK(bar.ends_with("\r\x1b[K"));                     // taken away
}
