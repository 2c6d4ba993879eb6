// 04-point-shadows: the program. Lamps that shine all round, with your shadows.
#include "01-transforms/functions.hpp"
#include "02-blinn-phong/lit_surface.hpp"
#include "04-point-shadows/lamp_cones.hpp"
#include "04-point-shadows/point_shadowed_surface.hpp"
#include "04-point-shadows/probes.hpp"
#include "04-point-shadows/scenes.hpp"
#include "04-point-shadows/studies.hpp"
#include "04-point-shadows/truth.hpp"
#include "app/scene_program.hpp"

namespace atelier {

namespace {

StepDescription describe() {
  std::vector<SettingSpec> settings = cube_settings();
  for (const auto& more : {point_scene_settings(), study_settings(), shadow_setting_specs(), lit_surface_settings()})
    settings.insert(settings.end(), more.begin(), more.end());
  return {
      .name = "04-point-shadows",
      .title = "Shadows all round a lamp",
      .scenes = point_scene_names(),
      .settings = settings,
      .outputs = {{"colour", Encoding::linear, "what is seen"},
                  {"shadow_factor", Encoding::data, "the share of one light that arrives: 1 lit, 0 in shadow"},
                  {"shadow_coordinate", Encoding::data, "the way from one lamp, as a share of its farthest distance"},
                  {"shadow_map", Encoding::data, "one lamp's cube as it is stored: +x -x +y above, -y +z -z below"}},
      .probes = point_shadow_probes()};
}

std::vector<std::unique_ptr<Feature>> features() {
  std::vector<std::unique_ptr<Feature>> list;
  auto lit = std::make_unique<LitSurface>();
  auto cones = std::make_unique<LampCones>(lit->lights());
  auto maps = std::make_unique<ShadowedSurface>(lit->lights(), cones->frusta());
  auto cubes = std::make_unique<PointShadowedSurface>(lit->lights(), maps->maps());
  list.push_back(std::move(lit));
  list.push_back(std::move(cones));
  list.push_back(std::move(maps));
  list.push_back(std::move(cubes));
  return list;
}

}  // namespace

}  // namespace atelier

extern "C" atelier::StepProgram* atelier_step_program() {
  using namespace atelier;
  return new SceneProgram(describe(), transform_functions(), features, make_point_scene, point_shadow_truth);
}
