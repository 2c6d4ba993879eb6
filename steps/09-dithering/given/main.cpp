// 09-dithering: the program. Scenes of your earlier steps, with few levels.
#include "01-transforms/given/functions.hpp"
#include "02-blinn-phong/given/lit_surface.hpp"
#include "03-shadow-mapping/given/shadowed_surface.hpp"
#include "08-post-processing/given/post_chain.hpp"
#include "09-dithering/given/bitmap.hpp"
#include "09-dithering/given/dither_pass.hpp"
#include "09-dithering/given/probes.hpp"
#include "09-dithering/given/scenes.hpp"
#include "09-dithering/given/truth.hpp"
#include "app/scene_program.hpp"

extern "C" atelier::StepProgram* atelier_step_program() {
  using namespace atelier;
  return new SceneProgram({
      .name = ATELIER_STEP,
      .title = ATELIER_STEP_TITLE,
      .scenes = dither_scenes(),
      .settings = {dither_settings(), post_settings(), shadow_setting_specs(), lit_surface_settings()},
      .outputs = dither_outputs(),
      .probes = dither_probes(),
      .transforms = transform_functions(),
      .features =
          [](FeatureList& list) {
            static const PointFrusta none;  // point lights have no shadows before step 04
            const auto& lit = list.add<LitSurface>();
            list.add<ShadowedSurface>(lit.lights(), none);
            list.add<PostChain>();
            list.add<DitherPass>();
          },
      .truth = dither_truth,
      .chain = chain_functions(),
      .write = write_bitmap,
  });
}
