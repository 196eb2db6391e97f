// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <time.h>

#include <cstdint>

namespace dioptre {

/// The processor time of this thread so far, in nanoseconds; what other programs take does not
/// count. 0 if it cannot be told.
inline std::int64_t thread_nanoseconds() {
  timespec time{};
  if (::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) != 0) return 0;
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

}  // namespace dioptre
