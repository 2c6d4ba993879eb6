// The oracle's input for a picture of a step that draws scenes.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "app/step_program.hpp"
#include "oracle/picture.hpp"

namespace atelier {

/// The scene without the step's approximations and without results of the student's functions. Plain data; the step
/// decides which settings only trade accuracy for speed and are ignored.
struct SceneTruth {
  Scene scene;                         ///< the part that triangles represent exactly; its camera is the scene's own
  std::optional<Camera> camera;        ///< if set, replaces the request's camera: for example by a light's view
  std::vector<oracle::Shape> shapes;   ///< the part that triangles only approximate
  oracle::Shading shading;             ///< shading of surfaces
  std::string output;                  ///< the oracle's output, if its name differs; empty: the requested one
  oracle::Lens lens = {};              ///< if set, replaces the projection of the camera
  std::function<Image(Image)> finish;  ///< if set, applied to the traced picture: for example an encoding
};

/// The step's given code builds it from the request (whose scene is a built-in one unless `model` is given), the
/// settings, and the scene of a model file. Throws Error if there is no truth.
using MakeTruth =
    std::function<SceneTruth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model)>;

/// Traces it with the oracle for the view settings: "depth.format" says whether depths are reversed,
/// "world.camera_relative" sets the origin of positions. Depth precision, the world's origin and culling do not affect
/// the truth. Throws Error for depths between planes that the renderer chooses ("camera.fit_depth"), for
/// "draw.wireframe", since edges have no width, and if the request's camera is out of range.
Image trace_scene(SceneTruth truth, const TruthRequest& request, const StepDescription& description,
                  const Settings& settings);

}  // namespace atelier
