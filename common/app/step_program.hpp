// The interface of a step program: scenes, settings, drawing, and probes. Each step's main.cpp defines one; the shell
// (command line, headless drawing, window) does the rest.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/probe.hpp"
#include "base/error.hpp"
#include "case/case.hpp"
#include "case/implementations.hpp"
#include "case/output.hpp"
#include "case/settings.hpp"
#include "gl/gl.hpp"
#include "gl/target.hpp"
#include "render/counts.hpp"
#include "scene/scene.hpp"

namespace atelier {

/// What --list prints.
struct StepDescription {
  std::string name;                   ///< "01-transforms"
  std::string title;                  ///< "Transforms and vertex buffers"
  bool imports = false;               ///< whether --scene takes model files too
  bool camera = true;                 ///< whether pictures depend on a camera
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
  double time = 0;  ///< animation time, seconds
};

/// One picture to trace with the oracle.
struct TruthRequest {
  std::string scene;                     ///< a built-in scene's name, or a model file
  CaseCamera camera;                     ///< missing values are the scene's
  glm::ivec2 size{256, 256};             ///< pixels
  std::string output = "colour";         ///< as for a frame, or "thing": which node is visible
  int samples = 1;                       ///< n x n per pixel, 1..64; 1: the pixel's centre, as in OpenGL
  std::function<void(double)> progress;  ///< called occasionally with the fraction done, 0..1
};

/// A visitor of a scene that is walked through, rather than looked at from around.
struct Walker {
  Camera camera;           ///< the visitor's eyes
  glm::dvec3 velocity{0};  ///< m/s, in the world; not 0: the visitor moves without being asked to, as in a jump
};

/// What the window asks a visitor to do.
struct Walking {
  glm::dvec2 velocity{0};  ///< m/s over the floor: to the right and ahead of where the visitor looks
  glm::dvec2 turn{0};      ///< radians: to the left, and up
};

class StepProgram {
 public:
  virtual ~StepProgram() = default;
  virtual const StepDescription& description() const = 0;

  /// Called once, when there is a context. Shaders are searched in `implementations`.
  virtual void open(Gl& gl, const Implementations& implementations) = 0;

  /// Makes a scene the current one. Throws Error for an unknown name.
  virtual void load(const std::string& scene, const Settings& settings) = 0;

  /// The scene's own camera.
  virtual Camera camera() const = 0;

  /// The depth format that a frame's target needs with these settings.
  virtual DepthFormat depth_format(const Settings&) const { return DepthFormat::depth24; }

  virtual void draw(const Frame& frame, const Settings& settings) = 0;

  /// Whether another drawing of the same frame would show more, since this one has left something for later.
  virtual bool wants_another_frame() const { return false; }

  /// Whether the window's controls walk through the loaded scene; otherwise they move the camera around its target.
  virtual bool is_walked() const { return false; }

  /// The visitor after `seconds`; called where is_walked. May change settings, such as the room where the visitor is.
  virtual Walker walk(const Walker& walker, const Walking&, double /*seconds*/, Settings&) { return walker; }

  /// The ground truth of a picture, row 0 on top: an exact version of `load` and `draw`, from given code and the oracle
  /// only. Works before `open`, without OpenGL. Settings that only trade accuracy for speed have no effect. Throws
  /// Error if there is no truth, which is the default.
  virtual Image truth(const TruthRequest& request, const Settings& settings) const;

  /// Writes a picture to a file in a format of its own; returns false if the file shall have the usual one.
  virtual bool write(const std::filesystem::path&, const Image&) const { return false; }

  /// The renderer's counts for the last frame.
  virtual SceneCounts counts() const { return {}; }

  /// Reloads shader files that have changed; returns the driver's log if it rejects them.
  virtual std::string reload_changed_shaders() { return {}; }
};

inline Image StepProgram::truth(const TruthRequest&, const Settings&) const {
  throw Error(description().name + " has no ground truth");
}

}  // namespace atelier

/// Defined by every step's main.cpp: creates the program, which the caller owns and must destroy before its context.
extern "C" atelier::StepProgram* atelier_step_program();
