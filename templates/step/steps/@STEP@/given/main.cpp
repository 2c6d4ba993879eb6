// @STEP@: the program. Scenes lit by your earlier steps, with your fog.
#include "01-transforms/given/functions.hpp"
#include "02-blinn-phong/given/lit_surface.hpp"
#include "@STEP@/given/feature.hpp"
#include "@STEP@/given/probes.hpp"
#include "@STEP@/given/scenes.hpp"
#include "@STEP@/given/truth.hpp"
#include "app/scene_program.hpp"

extern "C" atelier::StepProgram* atelier_step_program() {
  using namespace atelier;
  return new SceneProgram({
      .name = ATELIER_STEP,
      .title = ATELIER_STEP_TITLE,
      .scenes = @NAME@_scenes(),
      .settings = {@NAME@_settings(), lit_surface_settings()},
      .probes = @NAME@_probes(),
      .transforms = transform_functions(),
      .features =
          [](FeatureList& list) {
            list.add<LitSurface>();
            list.add<@TYPE@Feature>();
          },
      .truth = @NAME@_truth,
  });
}
