// A step program that draws scenes with features: what nearly every step is.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/scene_truth.hpp"
#include "app/step_program.hpp"
#include "render/renderer.hpp"

namespace atelier {

class SceneProgram : public StepProgram {
 public:
  using MakeFeatures = std::function<std::vector<std::unique_ptr<Feature>>()>;
  using MakeScene = std::function<Scene(const std::string& name, const Settings& settings)>;

  /// The description's outputs are completed by the renderer's own, its settings by those of the frame. Without
  /// `make_truth` there is no ground truth.
  /// `chain` runs the passes of features that have some.
  SceneProgram(StepDescription description, TransformFunctions transforms, MakeFeatures features, MakeScene make_scene,
               MakeTruth make_truth = {}, ChainFunctions chain = {});

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
  StepDescription description_;
  TransformFunctions transforms_;
  MakeFeatures make_features_;
  MakeScene make_scene_;
  MakeTruth make_truth_;
  ChainFunctions chain_;
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

/// "chain.format": how pictures between the passes of a chain are stored. A program that does not list it stores them
/// as the picture itself.
SettingSpec chain_format_setting();

/// Whether a program has a setting of this name.
bool lists(const StepDescription& description, const std::string& setting);

}  // namespace atelier
