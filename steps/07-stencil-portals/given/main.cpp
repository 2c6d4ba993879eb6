// 07-stencil-portals: the program. Places that are seen and entered through your portals.
#include "01-transforms/given/functions.hpp"
#include "02-blinn-phong/given/lit_surface.hpp"
#include "04-point-shadows/given/light_cones.hpp"
#include "04-point-shadows/given/point_shadowed_surface.hpp"
#include "05-normal-mapping/given/mapped_surface.hpp"
#include "07-stencil-portals/given/portal_lights.hpp"
#include "07-stencil-portals/given/portal_views.hpp"
#include "07-stencil-portals/given/probes.hpp"
#include "07-stencil-portals/given/scenes.hpp"
#include "07-stencil-portals/given/truth.hpp"
#include "07-stencil-portals/given/visitor.hpp"
#include "app/scene_program.hpp"

extern "C" atelier::StepProgram* atelier_step_program() {
  using namespace atelier;
  return new SceneProgram({
      .name = ATELIER_STEP,
      .title = ATELIER_STEP_TITLE,
      .scenes = portal_scenes(),
      .settings = {portal_settings(), portal_light_settings(), visitor_settings(), portal_scene_settings(),
                   normal_mapping_settings(), cube_settings(), shadow_setting_specs(), lit_surface_settings()},
      .probes = portal_probes(),
      .transforms = transform_functions(),
      .features =
          [](FeatureList& list) {
            const auto& lit = list.add<LitSurface>();
            const auto& cones = list.add<LightCones>(lit.lights());
            const auto& maps = list.add<ShadowedSurface>(lit.lights(), cones.frusta());
            list.add<PointShadowedSurface>(lit.lights(), maps.maps());
            list.add<PortalLights>(lit.lights());
            list.add<MappedSurface>();
            list.add<PortalViews>();
          },
      .visit = visit,
      .truth = portal_truth,
  });
}
