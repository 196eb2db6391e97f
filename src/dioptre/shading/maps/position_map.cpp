// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/maps/position_map.h"

#include <algorithm>

namespace dioptre {

void PositionMap::find_reach() {
  reach_ = positions_;
  for (std::size_t i = 1; i < reach_.size(); ++i) reach_[i] = std::max(reach_[i - 1], reach_[i]);
}

MapPlace PositionMap::find(double value) const {
  const std::uint32_t last = count_ - 1;
  if (count_ == 0) return {};
  if (positions_.empty()) {
    if (!(value > 0)) return {};
    const auto number = value < last ? static_cast<std::uint32_t>(value) : last;
    return {number, number, 0};
  }
  if (!(value > reach_[0])) return {};
  if (value > reach_[last]) return {last, last, 0};
  const auto found = std::lower_bound(reach_.begin(), reach_.end(), value);
  const auto i = static_cast<std::uint32_t>(found - reach_.begin());
  const double before = positions_[i - 1];
  return {i - 1, i, static_cast<float>((value - before) / (positions_[i] - before))};
}

}  // namespace dioptre
