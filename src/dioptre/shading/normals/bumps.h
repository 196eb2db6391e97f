// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "dioptre/core/vec.h"
#include "dioptre/scene/pattern.h"
#include "dioptre/shading/noise/noise.h"

namespace dioptre {

/// What the patterns that have their own way of making bumps add to a unit normal, for an amount of
/// 1: vector noise, cushions, or circular waves from fixed sources.
class Bump {
 public:
  /// True for bumps, dents, wrinkles, quilted, ripples and waves.
  static bool exists_for(const PatternData& data);

  Bump(const Pattern& pattern, NoiseGenerator generator, std::uint32_t wave_sources);

  /// At a point inside the warps.
  Vec3 at(Vec3 p) const;

 private:
  enum class Kind : std::uint8_t { kBumps, kDents, kWrinkles, kQuilted, kRipples, kWaves };
  static Kind kind_of(const PatternData& data);

  Kind kind_;
  NoiseGenerator generator_;
  std::uint32_t sources_;
  double frequency_, phase_;
  Quilted quilted_;
};

}  // namespace dioptre
