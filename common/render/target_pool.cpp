#include "render/target_pool.hpp"

#include "gl/debug.hpp"

namespace atelier {

std::shared_ptr<const Target> TargetPool::take(const TargetSpec& spec) {
  for (Entry& entry : entries_)
    if (entry.target.use_count() == 1 && entry.target->spec() == spec) {
      entry.used = true;
      return entry.target;
    }
  entries_.push_back({std::make_shared<const Target>(gl_, spec)});
  label(gl_, *entries_.back().target, "pooled target");
  return entries_.back().target;
}

void TargetPool::end_frame() {
  std::erase_if(entries_, [](const Entry& entry) { return !entry.used && entry.target.use_count() == 1; });
  for (Entry& entry : entries_) entry.used = false;
}

}  // namespace atelier
