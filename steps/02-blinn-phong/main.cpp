// 02-blinn-phong: the program. Scenes drawn with step 01's transforms and your light.
#include "01-transforms/functions.hpp"
#include "02-blinn-phong/blind.hpp"
#include "02-blinn-phong/lit_surface.hpp"
#include "02-blinn-phong/probes.hpp"
#include "02-blinn-phong/scenes.hpp"
#include "02-blinn-phong/truth.hpp"
#include "app/scene_program.hpp"

namespace atelier {

namespace {

StepDescription describe() {
  std::vector<SettingSpec> settings = lit_surface_settings();
  settings.insert(settings.begin(), shading_setting());
  settings.push_back(blind_setting());
  for (const SettingSpec& spec : blinn_phong_scene_settings()) settings.push_back(spec);
  return {.name = "02-blinn-phong",
          .title = "Light and materials after Blinn and Phong",
          .scenes = blinn_phong_scene_names(),
          .settings = settings,
          .outputs = {{"colour", Encoding::linear, "what is seen"},
                      {"diffuse", Encoding::linear, "the ambient and diffuse part alone"},
                      {"specular", Encoding::linear, "the highlights alone"},
                      {"encoded", Encoding::srgb, "what is seen, encoded by your srgb_encode"}},
          .probes = blinn_phong_probes()};
}

std::vector<std::unique_ptr<Feature>> features() {
  std::vector<std::unique_ptr<Feature>> list;
  auto lit = std::make_unique<LitSurface>();
  auto blind = std::make_unique<Blind>(lit->lights());
  list.push_back(std::move(lit));
  list.push_back(std::move(blind));
  return list;
}

}  // namespace

}  // namespace atelier

extern "C" atelier::StepProgram* atelier_step_program() {
  using namespace atelier;
  return new SceneProgram(describe(), transform_functions(), features, make_blinn_phong_scene, blinn_phong_truth);
}
