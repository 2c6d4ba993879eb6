// 04-point-shadows: the program. Lamps that shine all round, with your shadows.
#include "01-transforms/given/functions.hpp"
#include "02-blinn-phong/given/lit_surface.hpp"
#include "04-point-shadows/given/lamp_cones.hpp"
#include "04-point-shadows/given/point_shadowed_surface.hpp"
#include "04-point-shadows/given/probes.hpp"
#include "04-point-shadows/given/scenes.hpp"
#include "04-point-shadows/given/studies.hpp"
#include "04-point-shadows/given/truth.hpp"
#include "app/scene_program.hpp"

extern "C" atelier::StepProgram* atelier_step_program() {
  using namespace atelier;
  return new SceneProgram({
      .name = ATELIER_STEP,
      .title = ATELIER_STEP_TITLE,
      .scenes = point_scenes(),
      .settings = {cube_settings(), point_scene_settings(), study_settings(), shadow_setting_specs(),
                   lit_surface_settings()},
      .outputs = {shadow_factor_output(),
                  {"shadow_coordinate", Encoding::data, "the way from one lamp, as a share of its farthest distance"},
                  {"shadow_map", Encoding::data, "one lamp's cube as it is stored: +x -x +y above, -y +z -z below"}},
      .probes = point_shadow_probes(),
      .transforms = transform_functions(),
      .features =
          [](FeatureList& list) {
            const auto& lit = list.add<LitSurface>();
            const auto& cones = list.add<LampCones>(lit.lights());
            const auto& maps = list.add<ShadowedSurface>(lit.lights(), cones.frusta());
            list.add<PointShadowedSurface>(lit.lights(), maps.maps());
          },
      .truth = point_shadow_truth,
  });
}
