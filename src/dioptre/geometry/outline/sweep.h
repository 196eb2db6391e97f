// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "dioptre/core/bounds.h"
#include "dioptre/geometry/outline/outline.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// Which of an outline's points count as inside.
enum class FillRule : std::uint8_t { kEvenOdd, kNonZero };

/// Faces of a swept solid: its two caps, then one side per curve of the outline.
inline constexpr std::uint32_t kLowCap = 0, kHighCap = 1, kFirstSide = 2;

/// The ray as the sweeps see it: in the outline's plane, and along the sweep's axis. Its origin
/// has been moved by `shift` along the ray, close to the solid, where rounding is small.
struct SweepRay {
  Vec2 origin, direction;
  double height = 0, climb = 0;
  double shift = 0;
  double position_error = 0;  ///< how far the moved origin may be from the ray
};

/// Heights between which a solid lies: low <= high.
struct Slab {
  double low = 0, high = 1;
};

/// Appends the crossings of the ray with the outline swept straight from slab.low to slab.high, in
/// order, alternating, with t counted from the ray's own origin. `u` is the place on the curve.
void cross_linear_sweep(const Outline& outline, FillRule rule, Slab slab, const SweepRay& ray,
                        Crossings& out);

/// The same for the outline at height 1 scaled by the height (a cone over the outline, with its
/// apex at the origin), even-odd.
void cross_conic_sweep(const Outline& outline, Slab slab, const SweepRay& ray, Crossings& out);

/// Of the alternating crossings out[first..], keeps those in the range; returns whether the ray is
/// inside just after range.min.
bool keep_range(Crossings& out, std::size_t first, Interval range);

}  // namespace dioptre
