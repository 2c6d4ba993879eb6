// 04-point-shadows: the program. Point lights, with your shadows.
#include "01-transforms/given/functions.hpp"
#include "02-blinn-phong/given/lit_surface.hpp"
#include "04-point-shadows/given/light_cones.hpp"
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
      .outputs = {{"shadow_coordinate", Encoding::data,
                   "the vector from one light to the point, as a fraction of the farthest distance"},
                  shadow_factor_output(),
                  {"shadow_map", Encoding::data,
                   "the cube of one light as it is stored: +x -x +y above, -y +z -z below", Stage::other_view}},
      .probes = point_shadow_probes(),
      .transforms = transform_functions(),
      .features =
          [](FeatureList& list) {
            const auto& lit = list.add<LitSurface>();
            const auto& cones = list.add<LightCones>(lit.lights());
            const auto& maps = list.add<ShadowedSurface>(lit.lights(), cones.frusta());
            list.add<PointShadowedSurface>(lit.lights(), maps.maps());
          },
      .truth = point_shadow_truth,
  });
}
