// 10-artstyles: the program. Scenes of your earlier steps, painted and drawn.
#include "01-transforms/given/functions.hpp"
#include "02-blinn-phong/given/lit_surface.hpp"
#include "03-shadow-mapping/given/shadowed_surface.hpp"
#include "08-post-processing/given/post_chain.hpp"
#include "10-artstyles/given/probes.hpp"
#include "10-artstyles/given/scenes.hpp"
#include "10-artstyles/given/style_passes.hpp"
#include "10-artstyles/given/truth.hpp"
#include "app/scene_program.hpp"

extern "C" atelier::StepProgram* atelier_step_program() {
  using namespace atelier;
  return new SceneProgram({
      .name = ATELIER_STEP,
      .title = ATELIER_STEP_TITLE,
      .scenes = style_scenes(),
      .settings = {style_settings(), post_settings(), shadow_setting_specs(), lit_surface_settings()},
      .outputs = style_outputs(),
      .probes = style_probes(),
      .transforms = transform_functions(),
      .features =
          [](FeatureList& list) {
            static const PointFrusta none;  // point lights have no shadows before step 04
            const auto& lit = list.add<LitSurface>();
            list.add<ShadowedSurface>(lit.lights(), none);
            list.add<CubeOfViews>();
            list.add<PostChain>();
            list.add<StylePasses>();
          },
      .truth = style_truth,
      .chain = chain_functions(),
  });
}
