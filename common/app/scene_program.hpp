// A step program that draws scenes with features: what nearly every step is.
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

/// What a step that draws scenes consists of.
struct SceneStep {
  std::string name;   ///< "01-transforms"
  std::string title;  ///< "Transforms and vertex buffers"
  SceneTable scenes;
  std::vector<std::vector<SettingSpec>>
      settings;  ///< group by group, in the order of the panel; "draw.constants" and the frame's own follow
  std::vector<OutputSpec> outputs;  ///< beside "colour" and the renderer's own
  std::map<std::string, Probe> probes;
  TransformFunctions transforms;
  std::function<void(FeatureList&)> features;  ///< adds them
  MakeTruth truth;                             ///< absent: there is no ground truth
  ChainFunctions chain;                        ///< runs the passes of features that have some
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
  Image truth(const TruthRequest& request, const Settings& settings) const override;
  SceneCounts counts() const override { return renderer_->counts(); }
  std::string reload_changed_shaders() override { return renderer_->reload_changed_shaders(); }

 private:
  SceneStep step_;
  StepDescription description_;
  Scene scene_;
  std::vector<Box3> boxes_;  ///< of the scene's nodes; empty until somebody asks
  std::unique_ptr<Renderer> renderer_;
  /// What the scene was made of. Cases often differ in camera, size or output alone: it is then as they need it.
  struct Loaded {
    std::string scene;
    std::map<std::string, SettingValue, std::less<>> settings;
    bool operator==(const Loaded&) const = default;
  };
  std::optional<Loaded> loaded_;
};

/// The settings of step 01's part of the renderer: "depth.format", "world.camera_relative", "draw.wireframe",
/// "camera.fit_depth", "draw.cull". A program that lists them gets their effect. One that does not leaves out what is
/// outside the view: it stands on matrices that are right, while step 01 must show what wrong ones do.
std::vector<SettingSpec> view_settings();

/// "draw.constants": uniforms, or varyings for what all pixels of a draw read. Every scene program has it.
SettingSpec draw_constants_setting();

/// "chain.format": how pictures between the passes of a chain are stored. A program that does not list it stores them
/// as the picture itself.
SettingSpec chain_format_setting();

/// Whether a program has a setting of this name.
bool lists(const StepDescription& description, const std::string& setting);

}  // namespace atelier
