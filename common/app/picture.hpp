// Draws single pictures with a step program, without a window.
#pragma once

#include <memory>
#include <optional>

#include "app/cost.hpp"
#include "app/step_program.hpp"
#include "gl/context.hpp"

namespace atelier {

/// The scene's camera with what a case changes of it.
Camera apply(const CaseCamera& change, Camera camera);

/// The program's settings with what a case changes of them. Throws Error for an unknown name or a value out of range.
Settings settings_for(const StepDescription& description, const Case& c);

/// Throws Error with the outputs that there are, unless the program has this one.
void check_output(const StepDescription& description, const std::string& output);

/// Of one of the program's outputs; data for others, which the ground truth alone can show.
Encoding encoding_of(const StepDescription& description, const std::string& output);

class Painter {
 public:
  /// Opens `program` on `context`; both must outlive the painter.
  Painter(StepProgram& program, HeadlessContext& context, const Implementations& implementations);

  /// Draws a picture case, into the target that app/frame_settings.hpp says. Throws Error where a scene, a setting or
  /// an output is unknown, and where the driver has no target of the size that "frame.supersampling" makes of it.
  Image paint(const Case& picture, double time = 0);

  /// From then on each picture is drawn twice unwatched (shaders are compiled, caches filled) and then `frames` times
  /// by the clock. 0: once, untimed.
  void time_frames(int frames) { timed_frames_ = frames; }

  /// What the last picture has cost, without loading its scene and without the means that supersampling takes on the
  /// CPU.
  const DrawingCost& cost() const { return cost_; }

  /// Calls a probe on each of the case's inputs.
  std::vector<Numbers> probe(const Case& values);

  Gl& gl() { return context_.gl(); }

 private:
  const Target& target_for(const TargetSpec& spec);
  double draw(const Frame& frame, const Settings& settings);

  StepProgram& program_;
  HeadlessContext& context_;
  Implementations implementations_;
  ShaderProbe shader_probe_;
  std::optional<Target> target_;
  int timed_frames_ = 0;
  DrawingCost cost_;
};

}  // namespace atelier
