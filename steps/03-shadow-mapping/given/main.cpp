// 03-shadow-mapping: the program. Scenes lit by your earlier steps, with your shadows.
#include "01-transforms/given/functions.hpp"
#include "02-blinn-phong/given/lit_surface.hpp"
#include "03-shadow-mapping/given/probes.hpp"
#include "03-shadow-mapping/given/scenes.hpp"
#include "03-shadow-mapping/given/shadowed_surface.hpp"
#include "03-shadow-mapping/given/truth.hpp"
#include "app/scene_program.hpp"

extern "C" atelier::StepProgram* atelier_step_program() {
  using namespace atelier;
  return new SceneProgram({
      .name = ATELIER_STEP,
      .title = ATELIER_STEP_TITLE,
      .scenes = shadow_scenes(),
      .settings = {shadow_setting_specs(), shadow_scene_settings(), lit_surface_settings()},
      .outputs = {{"shadow_coordinate", Encoding::data, "(u, v, z) in the map of one light"},
                  shadow_factor_output(),
                  {"shadow_map", Encoding::data, "the map of one light as it is stored, 0 to 1", Stage::other_view}},
      .probes = shadow_mapping_probes(),
      .transforms = transform_functions(),
      .features =
          [](FeatureList& list) {
            static const PointFrusta none;  // point lights have no shadows before step 04
            const auto& lit = list.add<LitSurface>();
            list.add<ShadowedSurface>(lit.lights(), none);
          },
      .truth = shadow_truth,
  });
}
