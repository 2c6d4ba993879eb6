// 07-stencil-portals: the program. Places that are seen and entered through your portals.
#include "01-transforms/given/functions.hpp"
#include "02-blinn-phong/given/lit_surface.hpp"
#include "05-normal-mapping/given/mapped_surface.hpp"
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
      .settings = {portal_settings(), visitor_settings(), normal_mapping_settings(), lit_surface_settings()},
      .probes = portal_probes(),
      .transforms = transform_functions(),
      .features =
          [](FeatureList& list) {
            list.add<LitSurface>();
            list.add<MappedSurface>();
            list.add<PortalViews>();
          },
      .visit = visit,
      .truth = portal_truth,
  });
}
