// 12-gallery: the program. A round hall whose paintings are doors.
#include "01-transforms/given/functions.hpp"
#include "02-blinn-phong/given/lit_surface.hpp"
#include "04-point-shadows/given/light_cones.hpp"
#include "04-point-shadows/given/point_shadowed_surface.hpp"
#include "05-normal-mapping/given/mapped_surface.hpp"
#include "06-parallax-mapping/given/relief_surface.hpp"
#include "07-stencil-portals/given/portal_views.hpp"
#include "08-post-processing/given/post_chain.hpp"
#include "12-gallery/given/previews.hpp"
#include "12-gallery/given/probes.hpp"
#include "12-gallery/given/room_styles.hpp"
#include "12-gallery/given/scenes.hpp"
#include "12-gallery/given/truth.hpp"
#include "12-gallery/given/walk.hpp"
#include "app/scene_program.hpp"

extern "C" atelier::StepProgram* atelier_step_program() {
  using namespace atelier;
  return new SceneProgram({
      .name = ATELIER_STEP,
      .title = ATELIER_STEP_TITLE,
      .scenes = gallery_scenes(),
      .settings = {gallery_scene_settings(), room_style_settings(), walk_settings(), preview_settings(),
                   gallery_relief_settings(), portal_settings(), normal_mapping_settings(), cube_settings(),
                   shadow_setting_specs(), lit_surface_settings()},
      .outputs = room_style_outputs(),
      .probes = gallery_probes(),
      .transforms = transform_functions(),
      .features =
          [](FeatureList& list) {
            const auto& lit = list.add<LitSurface>();
            const auto& cones = list.add<LightCones>(lit.lights());
            const auto& maps = list.add<ShadowedSurface>(lit.lights(), cones.frusta());
            list.add<PointShadowedSurface>(lit.lights(), maps.maps());
            list.add<MappedSurface>();
            list.add<ReliefSurface>();
            list.add<PortalViews>();
            auto& styles = list.add<RoomStyles>();
            list.add<Previews>(styles);
          },
      .visit = guests_camera,
      .walk = walk,
      .truth = gallery_truth,
      .chain = chain_functions(),
  });
}
