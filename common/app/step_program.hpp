// What a step program is: its scenes, its settings, its drawing, and the functions that can be probed. Each step's
// main.cpp describes one; the shell (command line, headless drawing, window) does the rest.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/probe.hpp"
#include "base/error.hpp"
#include "case/case.hpp"
#include "case/implementations.hpp"
#include "case/settings.hpp"
#include "gl/gl.hpp"
#include "gl/target.hpp"
#include "image/colour.hpp"
#include "render/counts.hpp"
#include "scene/scene.hpp"

namespace atelier {

struct OutputSpec {
  std::string name;                      ///< "colour", "depth", ...
  Encoding encoding = Encoding::linear;  ///< linear colour, sRGB-encoded colour, or data (a depth, a coded direction)
  std::string help;                      ///< one sentence with the unit
};

/// What --list prints.
struct StepDescription {
  std::string name;                   ///< "01-transforms"
  std::string title;                  ///< "Transforms and vertex buffers"
  bool imports = false;               ///< whether --scene takes model files too
  bool camera = true;                 ///< whether there is anything that a camera would see otherwise from elsewhere
  std::vector<std::string> scenes;    ///< the first is the default
  std::vector<SettingSpec> settings;  ///< with those of app/frame_settings.hpp
  std::vector<OutputSpec> outputs;    ///< "colour" first
  std::map<std::string, Probe> probes;
};

/// One picture to draw.
struct Frame {
  const Target& target;
  Camera camera;
  std::string output = "colour";
  double time = 0;  ///< seconds on a fixed clock
};

/// One picture to trace: what it ought to be, from the oracle.
struct TruthRequest {
  std::string scene;                     ///< a built-in scene's name, or a model file
  CaseCamera camera;                     ///< what is absent is the scene's own
  glm::ivec2 size{256, 256};             ///< pixels
  std::string output = "colour";         ///< as for a frame; "thing" beside: which node is seen
  int samples = 1;                       ///< n x n a pixel, 1..64; 1: the pixel's middle, as OpenGL takes it
  std::function<void(double)> progress;  ///< told now and then how much is done, 0..1
};

class StepProgram {
 public:
  virtual ~StepProgram() = default;
  virtual const StepDescription& description() const = 0;

  /// Called once, when there is a context: shaders are found along `implementations`.
  virtual void open(Gl& gl, const Implementations& implementations) = 0;

  /// Makes a scene the current one. Throws Error for an unknown name.
  virtual void load(const std::string& scene, const Settings& settings) = 0;

  /// The scene's own camera.
  virtual Camera camera() const = 0;

  /// What the target of a frame must have under these settings.
  virtual DepthFormat depth_format(const Settings&) const { return DepthFormat::depth24; }

  virtual void draw(const Frame& frame, const Settings& settings) = 0;

  /// The ground truth for a picture, row 0 on top: what `load` and `draw` would show if they were exact, from given
  /// code and the oracle alone. Works before `open`, without OpenGL. Settings that only trade accuracy for speed change
  /// nothing. Throws Error where there is no truth, which is so for every picture unless a step says otherwise.
  virtual Image truth(const TruthRequest& request, const Settings& settings) const;

  /// What the last frame has cost beyond OpenGL's own counts.
  virtual SceneCounts counts() const { return {}; }

  /// Looks whether shader files have changed and takes the new ones; returns the driver's words where it refuses them.
  virtual std::string reload_changed_shaders() { return {}; }
};

inline Image StepProgram::truth(const TruthRequest&, const Settings&) const {
  throw Error(description().name + " has no ground truth");
}

}  // namespace atelier

/// Every step's main.cpp defines it: makes the program, which the caller owns and ends before its context.
extern "C" atelier::StepProgram* atelier_step_program();
