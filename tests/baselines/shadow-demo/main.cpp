// shadow-demo: the demos as one program with a step's command line.
#include "app/frame_settings.hpp"
#include "shadow-demo/demo.hpp"

namespace atelier::shadow_demo {

namespace {

class ShadowDemo : public StepProgram {
 public:
  const StepDescription& description() const override { return description_; }
  void open(Gl& gl, const Implementations&) override { gl_ = &gl; }

  void load(const std::string& scene, const Settings& settings) override {
    const Loaded wanted{scene, settings.choice("texture.format") == "8"};
    if (wanted == loaded_) return;
    if (scene == "cubes")
      demo_ = make_sun_demo(*gl_, wanted.compact_textures);
    else if (scene == "cube-room")
      demo_ = make_point_demo(*gl_, wanted.compact_textures);
    else
      throw Error("scene '" + scene + "': shadow-demo has cubes and cube-room");
    loaded_ = wanted;
  }

  Camera camera() const override { return demo_->scene().camera; }
  void draw(const Frame& frame, const Settings&) override { demo_->draw(frame, frame.output == "shadow_factor"); }

 private:
  static std::vector<SettingSpec> settings() {
    std::vector<SettingSpec> all = frame_settings();
    all.push_back(texture_format_setting());
    return all;
  }

  StepDescription description_{
      .name = "shadow-demo",
      .title = "LearnOpenGL's demos of shadows, rebuilt",
      .scenes = {"cubes", "cube-room"},
      .settings = settings(),
      .outputs = {{"colour", Encoding::linear, "what is seen"},
                  {"shadow_factor", Encoding::data, "the share of the light that arrives: 1 lit, 0 in shadow"}}};
  Gl* gl_ = nullptr;
  std::unique_ptr<Demo> demo_;
  struct Loaded {
    std::string scene;
    bool compact_textures = false;
    bool operator==(const Loaded&) const = default;
  } loaded_;  ///< what `demo_` was made of
};

}  // namespace

}  // namespace atelier::shadow_demo

extern "C" atelier::StepProgram* atelier_step_program() {
  return new atelier::shadow_demo::ShadowDemo;
}
