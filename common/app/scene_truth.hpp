// What the oracle is given for a picture of a step that draws scenes.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "app/step_program.hpp"
#include "oracle/picture.hpp"

namespace atelier {

/// The scene without the step's approximations: nothing that the student's functions made or changed is in it. Plain
/// data; which settings trade accuracy for speed, and so are passed over, is for the step to know.
struct SceneTruth {
  Scene scene;                         ///< what triangles show exactly; its camera is the scene's own
  std::optional<Camera> camera;        ///< from where it is seen, whatever the request says: a light, say
  std::vector<oracle::Shape> shapes;   ///< what they only approximate
  oracle::Shading shading;             ///< how surfaces look
  std::string output;                  ///< the oracle's, where the step's has another name; empty: the one asked for
  std::function<Image(Image)> finish;  ///< applied to the traced picture, where set: an encoding, say
};

/// The step's given code makes it, from the request (whose scene is a built-in one unless `model` is there), the
/// settings, and the scene that a model file held. Throws Error where there is no truth.
using MakeTruth =
    std::function<SceneTruth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model)>;

/// Has the oracle trace it as the view settings ask: "depth.format" says whether depths are reversed,
/// "world.camera_relative" from where positions are measured. Depth precision and where the world's origin lies are
/// no matter to the truth, nor is what is left out to save time; depths between planes that the renderer chooses
/// ("camera.fit_depth") have no truth: Error. Edges ("draw.wireframe") have no width and so no truth either: Error.
/// Throws Error also where the camera that the request makes is out of its ranges.
Image trace_scene(SceneTruth truth, const TruthRequest& request, const StepDescription& description,
                  const Settings& settings);

}  // namespace atelier
