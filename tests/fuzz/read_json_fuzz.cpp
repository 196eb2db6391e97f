// SPDX-License-Identifier: Apache-2.0
// Feeds any bytes to the reader of scene dumps: what it accepts, it writes and reads again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "dioptre/scene/json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto scene = dioptre::read_json({reinterpret_cast<const char*>(data), size});
  if (scene && !dioptre::read_json(dioptre::write_json(*scene))) std::abort();
  return 0;
}
