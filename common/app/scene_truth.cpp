#include "app/scene_truth.hpp"

#include "app/picture.hpp"
#include "app/scene_program.hpp"
#include "base/error.hpp"

namespace atelier {

Image trace_scene(SceneTruth truth, const TruthRequest& request, const StepDescription& description,
                  const Settings& settings) {
  if (lists(description, "draw.wireframe") && settings.flag("draw.wireframe"))
    throw Error("draw.wireframe has no ground truth: edges have no width");
  if (request.output == "depth" && lists(description, "camera.fit_depth") && settings.flag("camera.fit_depth"))
    throw Error(
        "output 'depth' has no ground truth under camera.fit_depth: the renderer chooses the near and far planes");
  truth.scene.camera = truth.camera ? *truth.camera : apply(request.camera, truth.scene.camera);
  oracle::PictureRequest wanted{
      .camera = truth.scene.camera,
      .size = request.size,
      .output = oracle::output_named(truth.output.empty() ? request.output : truth.output),
      .samples = request.samples,
      .shading = truth.shading,
      .lens = truth.lens,
      .progress = request.progress,
  };
  if (lists(description, "depth.format")) wanted.reversed_depth = settings.choice("depth.format") == "32f-reversed";
  if (lists(description, "world.camera_relative") && settings.flag("world.camera_relative"))
    wanted.position_origin = wanted.camera.eye;
  const oracle::World world(truth.scene, truth.shapes);
  Image image = oracle::trace(world, wanted);
  return truth.finish ? truth.finish(std::move(image)) : image;
}

}  // namespace atelier
