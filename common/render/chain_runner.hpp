// Runs the post-processing chain of a view, with two alternating targets.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "render/chain.hpp"
#include "render/programs.hpp"
#include "render/target_pool.hpp"

namespace atelier {

/// The passes that must run for an output: those up to the pass of this name, or all for "colour"; without identity
/// passes, and from the last one that begins a picture. None for any other output.
std::vector<ChainPass> passes_to_run(std::vector<ChainPass> passes, const std::string& output);

/// Whether the chain has a pass of this name.
bool has_pass(const std::vector<ChainPass>& passes, const std::string& output);

class ChainRunner {
 public:
  /// `functions` may be empty if no chain is ever run. All must outlive this.
  ChainRunner(Gl& gl, Programs& programs, TargetPool& pool, const ChainFunctions& functions)
      : gl_(gl), programs_(programs), pool_(pool), functions_(functions) {}

  /// Draws an output of the view into a target.
  using DrawOutput = std::function<void(const std::string& output, const Target& target)>;

  /// Draws the scene and runs the passes (at least one), the last of them into `target`. Pictures between passes have
  /// `format`; additional outputs are 32-bit floats. Throws Error if step 08's functions are missing or return an
  /// invalid target.
  void run(const std::vector<ChainPass>& passes, ColourFormat format, const Target& target, const DrawOutput& draw);

 private:
  struct Pictures;
  Pictures draw_scene(const std::vector<ChainPass>& passes, ColourFormat format, const Target& target,
                      const DrawOutput& draw);
  int next_target(int source) const;
  void run_shader(const ChainPass& pass, const Pictures& pictures, const Target* source, const Target& target);
  void run_on_cpu(const ChainPass& pass, const Pictures& pictures, const Target& source, const Target& target);

  Gl& gl_;
  Programs& programs_;
  TargetPool& pool_;
  const ChainFunctions& functions_;
};

}  // namespace atelier
