// Independent tasks on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace atelier {

/// Calls task(0) ... task(count - 1) on `threads` threads, each number once. Rethrows the first exception when all have
/// ended.
void for_each_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& task);

/// The number of CPU cores, at least 1.
int worker_threads();

}  // namespace atelier
