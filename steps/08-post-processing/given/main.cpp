// 08-post-processing: the program. Scenes lit by your earlier steps, and your chain of passes after them.
#include "01-transforms/given/functions.hpp"
#include "02-blinn-phong/given/lit_surface.hpp"
#include "08-post-processing/given/post_chain.hpp"
#include "08-post-processing/given/probes.hpp"
#include "08-post-processing/given/scenes.hpp"
#include "08-post-processing/given/truth.hpp"
#include "app/scene_program.hpp"

extern "C" atelier::StepProgram* atelier_step_program() {
  using namespace atelier;
  return new SceneProgram({
      .name = ATELIER_STEP,
      .title = ATELIER_STEP_TITLE,
      .scenes = post_scenes(),
      .settings = {post_settings(), lit_surface_settings()},
      .outputs = post_outputs(),
      .probes = post_probes(),
      .transforms = transform_functions(),
      .features =
          [](FeatureList& list) {
            list.add<LitSurface>();
            list.add<PostChain>();
          },
      .truth = post_truth,
      .chain = chain_functions(),
  });
}
