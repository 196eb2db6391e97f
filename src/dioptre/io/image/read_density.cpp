// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/image/read_density.h"

#include <cstdint>

namespace dioptre {
namespace {

constexpr std::size_t kHeader = 6;

/// A number of `count` bytes, the high one first.
std::uint32_t number_at(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < count; ++i) {
    number = number << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  }
  return number;
}

}  // namespace

Result<DensityGrid> decode_density(std::string_view bytes) {
  if (bytes.size() < kHeader) return fail("the file is too short for a df3 file");
  DensityGrid grid{number_at(bytes, 0, 2), number_at(bytes, 2, 2), number_at(bytes, 4, 2), {}};
  const std::uint64_t count = std::uint64_t{grid.width} * grid.height * grid.depth;
  const std::uint64_t room = bytes.size() - kHeader;
  if (count == 0 || room < count) return fail("the file has fewer values than its sizes say");
  const std::size_t width = room >= 4 * count ? 4 : room >= 2 * count ? 2 : 1;
  const double most = static_cast<double>((std::uint64_t{1} << 8 * width) - 1);
  grid.values.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    grid.values.push_back(static_cast<float>(number_at(bytes, kHeader + i * width, width) / most));
  }
  return grid;
}

}  // namespace dioptre
