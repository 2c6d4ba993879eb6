// 05-normal-mapping: the program. Surfaces with your normal maps, lit by your earlier steps.
#include "01-transforms/given/functions.hpp"
#include "02-blinn-phong/given/lit_surface.hpp"
#include "05-normal-mapping/given/mapped_surface.hpp"
#include "05-normal-mapping/given/probes.hpp"
#include "05-normal-mapping/given/scenes.hpp"
#include "05-normal-mapping/given/truth.hpp"
#include "app/scene_program.hpp"

extern "C" atelier::StepProgram* atelier_step_program() {
  using namespace atelier;
  return new SceneProgram({
      .name = ATELIER_STEP,
      .title = ATELIER_STEP_TITLE,
      .scenes = normal_mapping_scenes(),
      .settings = {normal_mapping_settings(), normal_mapping_scene_settings(), lit_surface_settings()},
      .outputs = {recorded_normal_output()},
      .probes = normal_mapping_probes(),
      .transforms = transform_functions(),
      .features =
          [](FeatureList& list) {
            list.add<LitSurface>();
            list.add<MappedSurface>();
          },
      .truth = normal_mapping_truth,
  });
}
