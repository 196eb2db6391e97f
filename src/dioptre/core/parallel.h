// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

namespace dioptre {

/// Calls task(i) for every i in [0, count), on at most `threads` threads (0: all there are), in any
/// order. Once `cancel` is set no further task is begun. Returns when all begun tasks are done.
/// Tasks must not throw.
void parallel_for(std::uint32_t count, std::uint32_t threads, const std::atomic<bool>* cancel,
                  const std::function<void(std::uint32_t)>& task);

}  // namespace dioptre
