// Targets that come and go within a frame: lent out, taken back, and used again.
#pragma once

#include <memory>
#include <vector>

#include "gl/target.hpp"

namespace atelier {

class TargetPool {
 public:
  explicit TargetPool(Gl& gl) : gl_(gl) {}

  /// A target of this kind that nobody else has, as long as the returned pointer lives. What it holds is left over from
  /// earlier use.
  std::shared_ptr<const Target> take(const TargetSpec& spec);

  /// Frees what was not used since the last call: to be called once for each frame.
  void end_frame();

  std::size_t size() const { return entries_.size(); }  ///< targets that it holds, lent or not

 private:
  struct Entry {
    std::shared_ptr<const Target> target;  ///< lent where somebody else holds it too
    bool used = true;                      ///< since the last end_frame
  };
  Gl& gl_;
  std::vector<Entry> entries_;
};

}  // namespace atelier
