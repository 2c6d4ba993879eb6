// A step program small enough to see through: two scenes, a setting of each type, one feature, one probe. Stands in for
// the real steps in tests of what is around them.
#pragma once

#include <filesystem>
#include <functional>

#include "../render/fake_transforms.hpp"
#include "app/scene_program.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "scene/shapes.hpp"

namespace atelier::test {

inline constexpr const char* step_name = "00-fake";

/// The surface's colour: the setting's, darker where it turns away from +z, and what it glows by itself.
inline constexpr const char* shade_glsl = R"(
uniform vec3 u_tint, u_glow;
vec3 shade(Surface surface) { return u_glow + u_tint * (0.25 + 0.75 * abs(normalize(surface.normal_world).z)); }
)";

/// Writes the step's shader files below `root`, as an implementation of it.
inline void write_fake_shaders(const std::filesystem::path& root) {
  write_file(root / transforms_name, std::string_view(transforms_glsl));
  write_file(root / step_name / "shade.glsl", std::string_view(shade_glsl));
}

class Tint : public Feature {
 public:
  void configure(const Settings& settings) override {
    const float brightness = float(settings.real("tint.brightness"));
    const std::string& colour = settings.choice("tint.colour");
    tint_ = brightness * (colour == "red" ? glm::vec3(1, 0.1f, 0.1f) : glm::vec3(0.2f, 0.5f, 1));
    glow_ = settings.colour("tint.glow");
  }
  Need need(const Scene&, const View&, const Node&) const override { return {.wanted = true}; }
  std::map<Slot, SlotCode> slots() const override {
    return {{Slot::shade, {std::string(step_name) + "/shade.glsl", "shade"}}};
  }
  void bind_view(Binder& binder, const Scene&, const Viewpoint&) override {
    binder.set("u_tint", tint_);
    binder.set("u_glow", glow_);
  }

 private:
  glm::vec3 tint_{1}, glow_{0};
};

inline std::vector<SettingSpec> fake_settings() {
  std::vector<SettingSpec> settings = view_settings();
  settings.push_back(
      {.name = "tint.colour", .fallback = std::string("red"), .choices = {"red", "blue"}, .help = "of the surface"});
  settings.push_back({.name = "tint.brightness", .fallback = 0.5, .low = 0, .high = 4, .help = "a factor on it"});
  settings.push_back({.name = "segments", .fallback = 48, .low = 3, .high = 4096, .help = "around the ring"});
  settings.push_back(
      {.name = "tint.glow", .fallback = Colour(0), .low = 0, .high = 2, .help = "light that the surface sends out"});
  return settings;
}

inline Scene fake_scene(const std::string& name, Mesh mesh) {
  Scene scene{.name = name};
  scene.meshes = {std::move(mesh)};
  scene.materials = {Material{}};
  scene.nodes = {Node{.rotation_axis = {1, 0, 0}, .rotation_angle = 0.6f, .mesh = 0}};
  scene.background = {0.02f, 0.03f, 0.05f};
  scene.camera.eye = name == "box" ? glm::dvec3(1, 1.5, 3) : glm::dvec3(0, 0, 3);
  return scene;
}

inline SceneTable fake_scenes() {
  return {{"box", [](const Settings&) { return fake_scene("box", make_box({.size = glm::vec3(1.5f)})); }},
          {"ring", [](const Settings& settings) {
             const int segments = settings.integer("segments");
             return fake_scene("ring", make_torus({.segments = segments}));
           }}};
}

inline SceneStep fake_step() {
  return {.name = step_name,
          .title = "A step for tests",
          .scenes = fake_scenes(),
          .settings = {fake_settings()},
          .probes = {{"twice",
                      [](ProbeContext&, const Arguments& arguments) { return Numbers{2 * arguments.number("x")}; }}},
          .transforms = fake_transforms(),
          .features = [](FeatureList& list) { list.add<Tint>(); }};
}

/// Draws nothing but silhouettes, with these settings alone.
inline SceneStep bare_step(std::vector<SettingSpec> settings = {}) {
  return {.name = "00-bare",
          .title = "No feature",
          .scenes = fake_scenes(),
          .settings = {std::move(settings)},
          .transforms = fake_transforms(),
          .features = [](FeatureList&) {}};
}

/// The program; `on_load` and `on_draw` run before each loading and drawing, and may throw as a student's code may.
class FakeStep : public SceneProgram {
 public:
  FakeStep() : SceneProgram(fake_step()) {}

  void load(const std::string& scene, const Settings& settings) override {
    ++loads;
    if (on_load) on_load();
    SceneProgram::load(scene, settings);
  }
  void draw(const Frame& frame, const Settings& settings) override {
    ++draws;
    last_time = frame.time;
    if (on_draw) on_draw();
    SceneProgram::draw(frame, settings);
  }

  bool is_walked() const override { return walked; }
  /// Moves the eye along x; whoever is beyond x = 10 changes a setting. Turning is a jump.
  Walker walk(const Walker& before, const Walking& walking, double seconds, Settings& settings) override {
    Walker walker = before;
    walker.camera.eye.x += (walking.velocity.y + before.velocity.x) * seconds;
    walker.velocity.x = walking.turn.x > 0 ? 1 : 0;
    if (walker.camera.eye.x > 10) settings.set("tint.colour", "blue");
    return walker;
  }

  bool wants_another_frame() const override { return unfinished; }

  bool walked = false, unfinished = false;
  std::function<void()> on_load, on_draw;
  int loads = 0, draws = 0;
  double last_time = -1;
};

}  // namespace atelier::test
