// What the window shows: a scene of a step program under chosen settings, seen from a camera that can be moved. Draws
// when something has changed, and keeps the last good picture when the student's code or shader fails. Knows OpenGL but
// no window, so that it can be tested without one.
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

/// What stands in the way of a new picture, in the words of whoever refused. Empty strings where nothing does.
struct Trouble {
  std::string drawing;  ///< thrown while a scene was loaded or drawn
  std::string shaders;  ///< a changed shader that the driver refuses
  std::string code;     ///< a rebuilt library that cannot be loaded
  bool any() const { return !drawing.empty() || !shaders.empty() || !code.empty(); }
};

class Viewer {
 public:
  /// Opens the program and takes scene, output, settings and camera from the command line; settings that it does not
  /// name have the defaults of a window (app/frame_settings.hpp). Throws Error where one of them is unknown or out of
  /// range; what fails later becomes `trouble`. The program and `gl` must outlive the viewer.
  Viewer(StepProgram& program, Gl& gl, const Implementations& implementations, const CommandLine& line);

  // What is shown. Every change asks for a new drawing.
  const StepDescription& description() const { return program_.description(); }
  const std::string& scene() const { return scene_; }
  const std::string& output() const { return output_; }
  const Settings& settings() const { return settings_; }
  Encoding encoding() const;  ///< of the output that is shown
  Camera camera() const;      ///< as it is drawn from

  void choose_scene(const std::string& name);  ///< a name or a model file; its camera becomes the current one
  void choose_output(const std::string& name);
  void set(const std::string& name, const SettingValue& value);
  void reset_settings();
  void resize(glm::ivec2 pixels);  ///< of the picture; sides below 1 count as 1

  // The camera, moved by window units on a picture that is `height` of them high.
  void turn(glm::dvec2 way, double height);  ///< half a turn over the picture's height
  void pan(glm::dvec2 way, double height);
  void dolly(double steps);
  void reset_camera();

  // The clock of animated scenes: stands at 0 s until it is run.
  bool playing() const { return playing_; }
  void play(bool on) { playing_ = on; }
  void advance(double seconds);

  /// Draws if anything has changed since the last time; true where there is a new picture. Never throws for what the
  /// program does: `trouble` says it, and the last good picture stays.
  bool draw();

  /// Takes changed shader files; true where the window should be drawn again.
  bool reload_shaders();
  /// Has the next draw() try again what has failed, for when its files have changed; false where nothing has.
  bool retry();

  /// The last good picture; null before the first.
  const Target* picture() const { return shown_.get(); }
  const DrawingCost& cost() const { return cost_; }  ///< of the last good picture; frames are not in it
  /// The median time of the last frames that compiled no shader, in seconds; 0 where there was none yet.
  double frame_seconds() const { return times_.median(); }

  Trouble trouble;

  /// The command line that opens the same view again; `line` gives what the viewer does not know.
  CommandLine command_line(CommandLine line) const;

 private:
  void load();
  void draw_into(const Target& target);

  StepProgram& program_;
  Gl& gl_;
  std::string scene_, output_;
  Settings settings_;
  glm::ivec2 size_{1, 1};

  bool must_load_ = true, must_draw_ = true;
  bool loaded_ = false;                      ///< the program holds the scene that is asked for
  std::optional<CaseCamera> first_camera_;   ///< from the command line, for the first scene only
  bool take_camera_ = true, moved_ = false;  ///< the next load gives the camera; somebody has moved it since
  Orbit start_, orbit_;

  bool playing_ = false;
  double time_ = 0;
  std::unique_ptr<Target> shown_, spare_;  ///< drawn into by turns: a drawing that fails half-way harms only the spare
  DrawingCost cost_;
  FrameTimes times_;
};

}  // namespace atelier
