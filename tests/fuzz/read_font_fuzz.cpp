// SPDX-License-Identifier: Apache-2.0
// Feeds any bytes to the reader of fonts.
#include "dioptre/geometry/text/text.h"
#include "memory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const dioptre::MemoryFile file(data, size);
  if (!file.good()) return 0;
  dioptre::Text text;
  text.font = file.path();
  text.text = "Ag";
  (void)dioptre::prepare(text);
  return 0;
}
