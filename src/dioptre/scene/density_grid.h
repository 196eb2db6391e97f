// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace dioptre {

/// Values on a regular grid in space, x running fastest, then y, then z.
struct DensityGrid {
  std::uint32_t width = 0;    ///< along x
  std::uint32_t height = 0;   ///< along y
  std::uint32_t depth = 0;    ///< along z
  std::vector<float> values;  ///< in [0, 1], width height depth of them
  bool operator==(const DensityGrid&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("width", self.width);
    visit("height", self.height);
    visit("depth", self.depth);
    visit("values", self.values);
  }
};

}  // namespace dioptre
