// A step program that draws scenes with features: the base of nearly every step.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/scene_table.hpp"
#include "app/scene_truth.hpp"
#include "app/step_program.hpp"
#include "render/feature_list.hpp"
#include "render/renderer.hpp"

namespace atelier {

/// The parts of a step that draws scenes.
struct SceneStep {
  std::string name;   ///< "01-transforms"
  std::string title;  ///< "Transforms and vertex buffers"
  SceneTable scenes;
  /// By group, in the order of the panel; "draw.constants" and the frame settings follow.
  std::vector<std::vector<SettingSpec>> settings;
  std::vector<OutputSpec> outputs;  ///< beside "colour" and the renderer's own
  std::map<std::string, Probe> probes;
  TransformFunctions transforms;
  std::function<void(FeatureList&)> features;  ///< adds them
  /// If set, moves the camera before a frame is drawn: where a visitor of the scene is, by the settings.
  std::function<Camera(const Scene& scene, const Camera& camera, const Settings& settings)> visit;
  /// If set, scenes of the table are walked through (StepProgram::walk), imported models are not.
  std::function<Walker(const Walker& walker, const Walking& walking, double seconds, Settings& settings)> walk;
  MakeTruth truth;       ///< empty: there is no ground truth
  ChainFunctions chain;  ///< for features with post-processing passes
  /// If set: StepProgram::write.
  std::function<bool(const std::filesystem::path& file, const Image& picture)> write;
};

class SceneProgram : public StepProgram {
 public:
  explicit SceneProgram(SceneStep step);

  const StepDescription& description() const override { return description_; }
  void open(Gl& gl, const Implementations& implementations) override;
  void load(const std::string& scene, const Settings& settings) override;
  Camera camera() const override { return scene_.camera; }
  DepthFormat depth_format(const Settings& settings) const override;
  void draw(const Frame& frame, const Settings& settings) override;
  bool wants_another_frame() const override { return renderer_->wants_another_frame(); }
  bool is_walked() const override;
  Walker walk(const Walker& walker, const Walking& walking, double seconds, Settings& settings) override;
  Image truth(const TruthRequest& request, const Settings& settings) const override;
  bool write(const std::filesystem::path& file, const Image& picture) const override {
    return step_.write && step_.write(file, picture);
  }
  SceneCounts counts() const override { return renderer_->counts(); }
  std::string reload_changed_shaders() override { return renderer_->reload_changed_shaders(); }

 private:
  SceneStep step_;
  StepDescription description_;
  Scene scene_;
  std::vector<Box3> boxes_;  ///< of the scene's nodes; computed when needed
  std::unique_ptr<Renderer> renderer_;
  /// What the loaded scene was made from. Cases often differ only in camera, size or output, and then it need not be
  /// loaded again.
  struct Loaded {
    std::string scene;
    std::map<std::string, SettingValue, std::less<>> settings;
    bool operator==(const Loaded&) const = default;
  };
  std::optional<Loaded> loaded_;
};

/// The settings of step 01's part of the renderer: "depth.format", "world.camera_relative", "draw.wireframe",
/// "camera.fit_depth", "draw.cull". They work in every program that lists them. A program without "draw.cull" always
/// culls: it can rely on correct matrices, while step 01 must show the effect of wrong ones.
std::vector<SettingSpec> view_settings();

/// "draw.constants": whether constants of a draw are uniforms or varyings. Every scene program has it.
SettingSpec draw_constants_setting();

/// "chain.format": how pictures between the passes of a chain are stored. Without it they are stored like the final
/// picture.
SettingSpec chain_format_setting();

/// Whether a program has a setting of this name.
bool lists(const StepDescription& description, const std::string& setting);

}  // namespace atelier
