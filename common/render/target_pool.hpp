// A pool of temporary targets.
#pragma once

#include <memory>
#include <type_traits>
#include <vector>

#include "gl/cube_target.hpp"
#include "gl/debug.hpp"
#include "gl/target.hpp"

namespace atelier {

class TargetPool {
 public:
  explicit TargetPool(Gl& gl) : gl_(gl) {}

  /// A target with this spec, exclusive while the returned pointer lives. Its contents are undefined.
  std::shared_ptr<const Target> take(const TargetSpec& spec) { return take_from(targets_, spec); }
  /// The same with six faces.
  std::shared_ptr<const CubeTarget> take(const CubeTargetSpec& spec) { return take_from(cubes_, spec); }

  /// Frees targets not used since the last call. Call it once per frame.
  void end_frame();

  std::size_t size() const { return targets_.size() + cubes_.size(); }  ///< number of targets, in use or free

 private:
  template <class Kind>
  struct Entry {
    std::shared_ptr<const Kind> target;  ///< in use if its use count is above 1
    bool used = true;                    ///< since the last end_frame
  };
  template <class Kind, class Spec>
  std::shared_ptr<const Kind> take_from(std::vector<Entry<Kind>>& entries, const Spec& spec);
  template <class Kind>
  void end_frame_of(std::vector<Entry<Kind>>& entries);

  Gl& gl_;
  std::vector<Entry<Target>> targets_;
  std::vector<Entry<CubeTarget>> cubes_;
};

template <class Kind, class Spec>
std::shared_ptr<const Kind> TargetPool::take_from(std::vector<Entry<Kind>>& entries, const Spec& spec) {
  for (Entry<Kind>& entry : entries)
    if (entry.target.use_count() == 1 && entry.target->spec() == spec) {
      entry.used = true;
      return entry.target;
    }
  entries.push_back({std::make_shared<const Kind>(gl_, spec)});
  if constexpr (std::is_same_v<Kind, Target>) label(gl_, *entries.back().target, "pooled target");
  return entries.back().target;
}

}  // namespace atelier
