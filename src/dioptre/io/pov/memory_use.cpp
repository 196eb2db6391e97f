// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/pov/memory_use.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

namespace dioptre::pov {

std::uint64_t resident_bytes() {
  const int file = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  if (file < 0) return 0;
  char text[128] = {};
  const bool read = ::read(file, text, sizeof text - 1) > 0;
  ::close(file);
  unsigned long long all = 0, resident = 0;
  if (!read || std::sscanf(text, "%llu %llu", &all, &resident) != 2) return 0;
  return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

}  // namespace dioptre::pov
