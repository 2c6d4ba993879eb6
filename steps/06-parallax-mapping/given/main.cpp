// 06-parallax-mapping: the program. Reliefs that shift and hide themselves, under the normal maps of step 05.
#include "01-transforms/given/functions.hpp"
#include "02-blinn-phong/given/lit_surface.hpp"
#include "05-normal-mapping/given/mapped_surface.hpp"
#include "06-parallax-mapping/given/probes.hpp"
#include "06-parallax-mapping/given/relief_surface.hpp"
#include "06-parallax-mapping/given/scenes.hpp"
#include "06-parallax-mapping/given/truth.hpp"
#include "app/scene_program.hpp"

extern "C" atelier::StepProgram* atelier_step_program() {
  using namespace atelier;
  return new SceneProgram({
      .name = ATELIER_STEP,
      .title = ATELIER_STEP_TITLE,
      .scenes = parallax_scenes(),
      .settings = {parallax_settings(), normal_mapping_settings(), lit_surface_settings()},
      .outputs = parallax_outputs(),
      .probes = parallax_mapping_probes(),
      .transforms = transform_functions(),
      .features =
          [](FeatureList& list) {
            list.add<LitSurface>();
            list.add<MappedSurface>();  // finds the tangent before the surface is displaced
            list.add<ReliefSurface>();
          },
      .truth = parallax_mapping_truth,
  });
}
