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

inline StepDescription fake_description() {
  StepDescription description{.name = step_name, .title = "A step for tests", .scenes = {"box", "ring"}};
  description.settings = view_settings();
  description.settings.push_back(
      {.name = "tint.colour", .fallback = std::string("red"), .choices = {"red", "blue"}, .help = "of the surface"});
  description.settings.push_back(
      {.name = "tint.brightness", .fallback = 0.5, .low = 0, .high = 4, .help = "a factor on it"});
  description.settings.push_back(
      {.name = "segments", .fallback = 48, .low = 3, .high = 4096, .help = "around the ring"});
  description.settings.push_back(
      {.name = "tint.glow", .fallback = Colour(0), .low = 0, .high = 2, .help = "light that the surface sends out"});
  description.outputs = {{"colour", Encoding::linear, "reflected light, linear"}};
  description.probes["twice"] = [](ProbeContext&, const Arguments& arguments) {
    return Numbers{2 * arguments.number("x")};
  };
  return description;
}

inline Scene fake_scene(const std::string& name, const Settings& settings) {
  Scene scene{.name = name};
  if (name == "box")
    scene.meshes = {make_box({.size = glm::vec3(1.5f)})};
  else if (name == "ring")
    scene.meshes = {make_torus({.segments = settings.integer("segments")})};
  else
    throw Error("scene '" + name + "': 00-fake offers box, ring");
  scene.materials = {Material{}};
  scene.nodes = {Node{.rotation_axis = {1, 0, 0}, .rotation_angle = 0.6f, .mesh = 0}};
  scene.background = {0.02f, 0.03f, 0.05f};
  scene.camera.eye = name == "box" ? glm::dvec3(1, 1.5, 3) : glm::dvec3(0, 0, 3);
  return scene;
}

/// The program; `on_load` and `on_draw` run before each loading and drawing, and may throw as a student's code may.
class FakeStep : public SceneProgram {
 public:
  FakeStep()
      : SceneProgram(
            fake_description(), fake_transforms(),
            [] {
              std::vector<std::unique_ptr<Feature>> features;
              features.push_back(std::make_unique<Tint>());
              return features;
            },
            fake_scene) {}

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

  std::function<void()> on_load, on_draw;
  int loads = 0, draws = 0;
  double last_time = -1;
};

}  // namespace atelier::test
