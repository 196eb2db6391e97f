// SPDX-License-Identifier: Apache-2.0
// Feeds any bytes to the reader of images: it gives an image or a reason.
#include <cstdlib>

#include "dioptre/io/image/decoders.h"
#include "dioptre/io/image/read_image.h"
#include "memory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace dioptre;
  constexpr std::uint64_t kMostPixels = 1 << 16;
  const MemoryFile file(data, size);
  if (!file.good()) return 0;
  ReadImageOptions options;
  options.max_pixels = kMostPixels;
  if (const auto image = read_image(file.path(), options)) {
    const std::size_t pixels = std::size_t{image->width} * image->height;
    if (image->pixels.size() != pixels * image->channels) std::abort();
  }
  // TGA files are known by their names only.
  if (size > 0) (void)decode_simple({reinterpret_cast<const char*>(data), size}, kMostPixels);
  return 0;
}
