#include "render/target_pool.hpp"

namespace atelier {

template <class Kind>
void TargetPool::end_frame_of(std::vector<Entry<Kind>>& entries) {
  std::erase_if(entries, [](const Entry<Kind>& entry) { return !entry.used && entry.target.use_count() == 1; });
  for (Entry<Kind>& entry : entries) entry.used = false;
}

void TargetPool::end_frame() {
  end_frame_of(targets_);
  end_frame_of(cubes_);
}

}  // namespace atelier
