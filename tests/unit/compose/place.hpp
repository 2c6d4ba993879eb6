// The features of steps 02 to 06 on a renderer, with room for others beside them.
#pragma once

#include "01-transforms/given/functions.hpp"
#include "02-blinn-phong/given/lit_surface.hpp"
#include "02-blinn-phong/given/scenes.hpp"
#include "03-shadow-mapping/given/scenes.hpp"
#include "03-shadow-mapping/given/shadowed_surface.hpp"
#include "04-point-shadows/given/light_cones.hpp"
#include "04-point-shadows/given/point_shadowed_surface.hpp"
#include "04-point-shadows/given/scenes.hpp"
#include "04-point-shadows/given/studies.hpp"
#include "05-normal-mapping/given/mapped_surface.hpp"
#include "06-parallax-mapping/given/relief_surface.hpp"
#include "base/file.hpp"
#include "catch.hpp"
#include "gl/context.hpp"
#include "render/feature_list.hpp"
#include "render/renderer.hpp"

namespace atelier::test {

inline std::vector<SettingSpec> all_settings() {
  std::vector<SettingSpec> all = lit_surface_settings();
  for (const auto& more : {blinn_phong_scene_settings(), shadow_setting_specs(), cube_settings()})
    all.insert(all.end(), more.begin(), more.end());
  const auto add_new = [&](const std::vector<SettingSpec>& more) {
    for (const SettingSpec& spec : more)
      if (std::ranges::none_of(all, [&](const SettingSpec& known) { return known.name == spec.name; }))
        all.push_back(spec);
  };
  add_new(shadow_scene_settings());
  add_new(point_scene_settings());
  add_new(study_settings());
  add_new(normal_mapping_settings());
  add_new(parallax_settings());
  return all;
}

inline FeatureList features_of(int step) {
  FeatureList list;
  static const PointFrusta none;
  const auto& lit = list.add<LitSurface>();
  if (step == 3) list.add<ShadowedSurface>(lit.lights(), none);
  if (step == 4) {
    const auto& cones = list.add<LightCones>(lit.lights());
    const auto& maps = list.add<ShadowedSurface>(lit.lights(), cones.frusta());
    list.add<PointShadowedSurface>(lit.lights(), maps.maps());
  }
  return list;
}

/// Normal maps and reliefs, behind the features of a step.
inline FeatureList with_reliefs(int step) {
  FeatureList list = features_of(step);
  list.add<MappedSurface>();
  list.add<ReliefSurface>();
  return list;
}

/// The largest difference of a channel, alpha apart.
inline double largest_difference(const Image& a, const Image& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i)
    for (int channel = 0; channel < 3; ++channel)
      largest = std::max(largest, std::abs(double((&a.pixels()[i].r)[channel]) - (&b.pixels()[i].r)[channel]));
  return largest;
}

/// Draws scenes with features of the steps.
struct Place {
  TemporaryFolder folder;  ///< for shaders of features that a test brings
  std::unique_ptr<HeadlessContext> context = make_headless_context();
  Settings settings;
  std::unique_ptr<Renderer> renderer;

  /// `more` are settings of features that a test brings.
  explicit Place(std::vector<SettingSpec> more = {}) {
    const std::vector<SettingSpec> known = all_settings();
    more.insert(more.begin(), known.begin(), known.end());
    settings = Settings(std::move(more));
  }
  /// Takes these features from now on.
  void open(FeatureList features, const RenderOptions& options = {}) {
    const std::filesystem::path root = ATELIER_SOURCE_DIR;
    renderer = std::make_unique<Renderer>(
        context->gl(), Implementations({{folder.path(), ""}, {root / "solutions", ""}, {root / "steps", ""}}),
        transform_functions(), features.take());
    renderer->configure(settings, options);
  }
  Image draw(const Scene& scene, const char* output = "colour") {
    renderer->prepare(scene);
    const Target target(context->gl(), {.width = 96, .height = 96, .depth = DepthFormat::depth24_stencil8});
    renderer->render({.camera = scene.camera, .output = output, .cull = true}, target);
    return target.read_colour(context->gl());
  }
};

}  // namespace atelier::test
