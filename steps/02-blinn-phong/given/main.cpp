// 02-blinn-phong: the program. Scenes drawn with step 01's transforms and your light.
#include "01-transforms/given/functions.hpp"
#include "02-blinn-phong/given/blind.hpp"
#include "02-blinn-phong/given/lit_surface.hpp"
#include "02-blinn-phong/given/probes.hpp"
#include "02-blinn-phong/given/scenes.hpp"
#include "02-blinn-phong/given/truth.hpp"
#include "app/scene_program.hpp"

extern "C" atelier::StepProgram* atelier_step_program() {
  using namespace atelier;
  return new SceneProgram({
      .name = ATELIER_STEP,
      .title = ATELIER_STEP_TITLE,
      .scenes = blinn_phong_scenes(),
      .settings = {{shading_setting()}, lit_surface_settings(), {blind_setting()}, blinn_phong_scene_settings()},
      .outputs = {{"diffuse", Encoding::linear, "the ambient and diffuse part alone"},
                  {"specular", Encoding::linear, "the highlights alone"},
                  {"encoded", Encoding::srgb, "what is seen, encoded by your srgb_encode", Stage::after_colour}},
      .probes = blinn_phong_probes(),
      .transforms = transform_functions(),
      .features =
          [](FeatureList& list) {
            const auto& lit = list.add<LitSurface>();
            list.add<Blind>(lit.lights());
          },
      .truth = blinn_phong_truth,
  });
}
