// A median of frame times.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace atelier {

/// The last 31 frame times. Their median, unlike their mean, ignores single slow frames.
class FrameTimes {
 public:
  void add(double seconds) {
    times_[next_] = seconds;
    next_ = (next_ + 1) % times_.size();
    count_ = std::min(count_ + 1, times_.size());
  }

  /// Seconds; for an even number the upper of the two middle ones; 0 without frames.
  double median() const {
    if (count_ == 0) return 0;
    auto sorted = times_;
    const auto middle = sorted.begin() + std::ptrdiff_t(count_ / 2);
    std::nth_element(sorted.begin(), middle, sorted.begin() + std::ptrdiff_t(count_));
    return *middle;
  }

 private:
  std::array<double, 31> times_{};
  std::size_t next_ = 0, count_ = 0;
};

}  // namespace atelier
