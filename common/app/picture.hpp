// Draws single pictures with a step program, without a window.
#pragma once

#include <memory>
#include <optional>

#include "app/cost.hpp"
#include "app/step_program.hpp"
#include "gl/context.hpp"

namespace atelier {

/// The scene's camera with a case's changes.
Camera apply(const CaseCamera& change, Camera camera);

/// The program's settings with a case's changes. Throws Error for an unknown name or a value out of range.
Settings settings_for(const StepDescription& description, const Case& c);

/// Throws Error listing the outputs unless the program has this one.
void check_output(const StepDescription& description, const std::string& output);

/// The encoding of one of the program's outputs; data for others, which only the ground truth has.
Encoding encoding_of(const StepDescription& description, const std::string& output);

class Painter {
 public:
  /// Opens `program` on `context`; both must outlive the painter.
  Painter(StepProgram& program, HeadlessContext& context, const Implementations& implementations);

  /// Draws a picture case, into the target of app/frame_settings.hpp. Throws Error if a scene, a setting or an output
  /// is unknown, or if the size after "frame.supersampling" exceeds the driver's limit.
  Image paint(const Case& picture, double time = 0);

  /// From now on each picture is drawn twice untimed (to compile shaders and fill caches), then `frames` times timed.
  /// 0: once, untimed.
  void time_frames(int frames) { timed_frames_ = frames; }

  /// From now on the cost of each picture has its fragments, or no longer. A picture whose frames are timed is drawn
  /// once more for it.
  void count_fragments(bool wanted) { counts_fragments_ = wanted; }

  /// The cost of the last picture, without loading its scene and without the CPU's averaging for supersampling.
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
  bool counts_fragments_ = false;
  DrawingCost cost_;
};

}  // namespace atelier
