// 03-shadow-mapping: the program. Scenes lit by your earlier steps, with your shadows.
#include "01-transforms/functions.hpp"
#include "02-blinn-phong/lit_surface.hpp"
#include "03-shadow-mapping/probes.hpp"
#include "03-shadow-mapping/scenes.hpp"
#include "03-shadow-mapping/shadowed_surface.hpp"
#include "03-shadow-mapping/truth.hpp"
#include "app/scene_program.hpp"

namespace atelier {

namespace {

StepDescription describe() {
  std::vector<SettingSpec> settings = shadow_setting_specs();
  for (const SettingSpec& spec : shadow_scene_settings()) settings.push_back(spec);
  for (const SettingSpec& spec : lit_surface_settings()) settings.push_back(spec);
  return {.name = "03-shadow-mapping",
          .title = "Shadow mapping",
          .scenes = shadow_scene_names(),
          .settings = settings,
          .outputs = {{"colour", Encoding::linear, "what is seen"},
                      {"shadow_factor", Encoding::data, "the share of one light that arrives: 1 lit, 0 in shadow"},
                      {"shadow_coordinate", Encoding::data, "(u, v, z) of one light's map"},
                      {"shadow_map", Encoding::data, "one light's map as it is stored, 0 to 1"}},
          .probes = shadow_mapping_probes()};
}

std::vector<std::unique_ptr<Feature>> features() {
  std::vector<std::unique_ptr<Feature>> list;
  auto lit = std::make_unique<LitSurface>();
  static const PointFrusta none;  // point lights have no shadows before step 04
  auto shadowed = std::make_unique<ShadowedSurface>(lit->lights(), none);
  list.push_back(std::move(lit));
  list.push_back(std::move(shadowed));
  return list;
}

}  // namespace

}  // namespace atelier

extern "C" atelier::StepProgram* atelier_step_program() {
  using namespace atelier;
  return new SceneProgram(describe(), transform_functions(), features, make_shadow_scene, shadow_truth);
}
