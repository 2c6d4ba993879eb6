// relief-demo: the wall as a program with a step's command line. The scene names the chapter: "wall" of step 05 is
// normal mapped, "bricks" of step 06 parallax mapped.
#include "05-normal-mapping/given/scenes.hpp"
#include "06-parallax-mapping/given/scenes.hpp"
#include "app/frame_settings.hpp"
#include "relief-demo/wall.hpp"

namespace atelier::relief_demo {

namespace {

class ReliefDemo : public StepProgram {
 public:
  const StepDescription& description() const override { return description_; }
  void open(Gl& gl, const Implementations&) override { gl_ = &gl; }

  void load(const std::string& scene, const Settings& settings) override {
    const Loaded wanted{scene,
                        settings.real("parallax.depth"),
                        {settings.choice("texture.format") == "8", settings.choice("normal.format") == "8"}};
    if (wall_ && wanted == loaded_) return;
    if (scene == "wall")
      wall_.emplace(*gl_, make_scene(normal_mapping_scenes(), scene, settings), 0, wanted.formats);
    else
      wall_.emplace(*gl_, make_scene(parallax_scenes(), scene, settings), wanted.depth, wanted.formats);
    loaded_ = wanted;
  }

  Camera camera() const override { return wall_->scene().camera; }
  void draw(const Frame& frame, const Settings&) override { wall_->draw(frame); }

 private:
  static std::vector<SettingSpec> settings() {
    std::vector<SettingSpec> all = frame_settings();
    all.push_back(texture_format_setting());
    all.push_back({.name = "normal.format",
                   .fallback = std::string("32"),
                   .choices = {"32", "8"},
                   .help = "how normals and depths are stored: floats, or 8 bits per channel"});
    all.push_back({.name = "parallax.depth",
                   .fallback = 0.06,
                   .low = 0.001,
                   .high = 0.2,
                   .help = "depth of the relief, as a fraction of the texture's side"});
    return all;
  }

  StepDescription description_{.name = "relief-demo",
                               .title = "LearnOpenGL's wall with normal and parallax mapping, rebuilt",
                               .scenes = {"wall", "bricks"},
                               .settings = settings(),
                               .outputs = {{"colour", Encoding::linear, "what is seen"},
                                           {"normal", Encoding::data, "the normal n in world space, as n/2 + 1/2"},
                                           {"texcoord", Encoding::data, "the texture coordinate as (u, v, 0)"}}};
  Gl* gl_ = nullptr;
  std::optional<Wall> wall_;
  struct Loaded {
    std::string scene;
    double depth = 0;
    MapFormats formats;
    bool operator==(const Loaded&) const = default;
  } loaded_;  ///< what `wall_` was made of
};

}  // namespace

}  // namespace atelier::relief_demo

extern "C" atelier::StepProgram* atelier_step_program() {
  return new atelier::relief_demo::ReliefDemo;
}
