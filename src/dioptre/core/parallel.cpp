// SPDX-License-Identifier: Apache-2.0
#include "dioptre/core/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <optional>
#include <thread>

namespace dioptre {

void parallel_for(std::uint32_t count, std::uint32_t threads, const std::atomic<bool>* cancel,
                  const std::function<void(std::uint32_t)>& task) {
  const std::uint32_t cores = std::max(1u, std::thread::hardware_concurrency());
  const std::uint32_t wanted = threads == 0 ? cores : threads;
  const auto run = [&](std::uint32_t i) {
    if (!cancel || !cancel->load(std::memory_order_relaxed)) task(i);
  };
  if (wanted == 1) {
    for (std::uint32_t i = 0; i < count; ++i) run(i);
    return;
  }
  // More threads than cores are given when they are asked for.
  std::optional<tbb::global_control> more;
  if (wanted > cores) more.emplace(tbb::global_control::max_allowed_parallelism, wanted);
  tbb::task_arena arena(static_cast<int>(wanted));
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::uint32_t>(0, count, 1),
        [&](const tbb::blocked_range<std::uint32_t>& range) {
          for (std::uint32_t i = range.begin(); i != range.end(); ++i) run(i);
        },
        tbb::simple_partitioner());
  });
}

}  // namespace dioptre
