// The content of the window: a scene of a step program with chosen settings and a movable camera. Draws when something
// has changed, and keeps the last good picture when the student's code or shader fails. Needs OpenGL but no window, so
// it can be tested without one.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/command_line.hpp"
#include "app/cost.hpp"
#include "app/step_program.hpp"
#include "app/window/frame_times.hpp"
#include "app/window/orbit.hpp"

namespace atelier {

/// Error messages that prevent a new picture; empty if there is no error.
struct Trouble {
  std::string drawing;  ///< thrown while a scene was loaded or drawn
  std::string shaders;  ///< for a changed shader that the driver rejects
  std::string code;     ///< for a rebuilt library that cannot be loaded
  bool any() const { return !drawing.empty() || !shaders.empty() || !code.empty(); }
};

class Viewer {
 public:
  /// Opens the program and takes scene, output, settings and camera from the command line; other settings have the
  /// window's defaults (app/frame_settings.hpp). Throws Error if one of them is unknown or out of range; later errors
  /// go to `trouble`. The program and `gl` must outlive the viewer.
  Viewer(StepProgram& program, Gl& gl, const Implementations& implementations, const CommandLine& line);

  // What is shown. Every change triggers a new drawing.
  const StepDescription& description() const { return program_.description(); }
  const std::string& scene() const { return scene_; }
  const std::string& output() const { return output_; }
  const Settings& settings() const { return settings_; }
  Encoding encoding() const;  ///< of the current output
  Camera camera() const;      ///< the current camera

  void choose_scene(const std::string& name);  ///< a name or a model file; its camera becomes the current one
  void choose_output(const std::string& name);
  void set(const std::string& name, const SettingValue& value);
  void reset_settings();
  void resize(glm::ivec2 pixels);  ///< of the picture; sides below 1 count as 1

  // Camera motion in window units on a picture that is `height` units high. Where the scene is walked through, they
  // look around, step aside, and walk.
  void turn(glm::dvec2 way, double height);  ///< half a turn per picture height
  void pan(glm::dvec2 way, double height);
  void dolly(double steps);
  void arrow(glm::dvec2 direction);  ///< x to the right, y up: turns the camera a little, or walks
  void reset_camera();

  /// Whether the scene is walked through.
  bool walked() const { return loaded_ && program_.is_walked(); }

  // The animation clock: stays at 0 s until it is started. A visitor in the air moves too, and a frame that has left
  // something for the next one.
  bool playing() const { return playing_; }
  bool moving() const { return playing_ || unfinished_ || (walked() && walker_.velocity != glm::dvec3(0)); }
  void play(bool on) { playing_ = on; }
  void advance(double seconds);

  /// Draws if anything has changed; true if there is a new picture. Does not throw errors of the program: they go to
  /// `trouble`, and the last good picture stays.
  bool draw();

  /// Reloads changed shader files; true if the window must be redrawn.
  bool reload_shaders();
  /// Makes the next draw() retry after a failure, for when files have changed; false if nothing has failed.
  bool retry();

  /// The last good picture; null before the first.
  const Target* picture() const { return shown_.get(); }
  const DrawingCost& cost() const { return cost_; }  ///< of the last good picture, without frame times
  /// The median time in seconds of the last frames that compiled no shader; 0 if there was none yet.
  double frame_seconds() const { return times_.median(); }

  Trouble trouble;

  /// The command line that opens the same view again; `line` provides the options that the viewer does not know.
  CommandLine command_line(CommandLine line) const;

 private:
  void load();
  void begin_at(const Camera& camera);
  void walk(const Walking& walking, double seconds);
  void draw_into(const Target& target);

  StepProgram& program_;
  Gl& gl_;
  std::string scene_, output_;
  Settings settings_;
  glm::ivec2 size_{1, 1};

  bool must_load_ = true, must_draw_ = true;
  bool unfinished_ = false;                  ///< StepProgram::wants_another_frame
  bool loaded_ = false;                      ///< the program has loaded the current scene
  std::optional<CaseCamera> first_camera_;   ///< from the command line, for the first scene only
  bool take_camera_ = true, moved_ = false;  ///< the next load sets the camera; the camera has been moved
  Orbit start_, orbit_;
  Walker walker_;

  bool playing_ = false;
  double time_ = 0;
  std::unique_ptr<Target> shown_, spare_;  ///< double buffering: a failed drawing changes only the spare
  DrawingCost cost_;
  FrameTimes times_;
};

}  // namespace atelier
