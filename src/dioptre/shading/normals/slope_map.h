// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dioptre/scene/normal.h"
#include "dioptre/shading/maps/position_map.h"

namespace dioptre {

/// The profile that a slope map makes of a pattern's values: cubics through heights with given
/// slopes, which count per entry, not per unit of the value (measured). Without entries the value
/// itself.
class SlopeMap {
 public:
  explicit SlopeMap(const std::vector<SlopeEntry>& entries)
      : places_(entries, false), entries_(entries) {}

  double height(double value) const {
    if (entries_.empty()) return value;
    const MapPlace place = places_.find(value);
    const SlopeEntry &a = entries_[place.first], &b = entries_[place.second];
    if (place.share == 0) return a.height;
    const double t = place.share, t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * a.height + (t3 - 2 * t2 + t) * a.slope +
           (3 * t2 - 2 * t3) * b.height + (t3 - t2) * b.slope;
  }

 private:
  PositionMap places_;
  std::vector<SlopeEntry> entries_;
};

}  // namespace dioptre
