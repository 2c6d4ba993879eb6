// What a step program is: its scenes, its settings, its drawing, and the functions that can be probed. Each step's
// main.cpp describes one; the shell (command line, headless drawing, window) does the rest.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/probe.hpp"
#include "case/case.hpp"
#include "case/implementations.hpp"
#include "case/settings.hpp"
#include "gl/gl.hpp"
#include "gl/target.hpp"
#include "image/colour.hpp"
#include "scene/scene.hpp"

namespace atelier {

struct OutputSpec {
  std::string name;                      ///< "colour", "depth", ...
  Encoding encoding = Encoding::linear;  ///< linear colour, sRGB-encoded colour, or data (a depth, a coded direction)
  std::string help;                      ///< one sentence with the unit
};

/// What --list prints.
struct StepDescription {
  std::string name;                 ///< "01-transforms"
  std::string title;                ///< "Transforms and vertex buffers"
  bool imports = false;             ///< whether --scene takes model files too
  bool camera = true;               ///< whether there is anything that a camera would see otherwise from elsewhere
  std::vector<std::string> scenes;  ///< the first is the default
  std::vector<SettingSpec> settings;
  std::vector<OutputSpec> outputs;  ///< "colour" first
  std::map<std::string, Probe> probes;
};

/// One picture to draw.
struct Frame {
  const Target& target;
  Camera camera;
  std::string output = "colour";
  double time = 0;  ///< seconds on a fixed clock
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

  /// Looks whether shader files have changed and takes the new ones; returns the driver's words where it refuses them.
  virtual std::string reload_changed_shaders() { return {}; }
};

}  // namespace atelier

/// Every step's main.cpp defines it: makes the program, which the caller owns and ends before its context.
extern "C" atelier::StepProgram* atelier_step_program();
