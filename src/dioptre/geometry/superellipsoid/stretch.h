// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "dioptre/core/vec.h"

namespace dioptre {

/// The part of a ray in the box from -1 to 1: p = origin + s step, s in [0, 1].
struct BoxStretch {
  Vec3 origin, step;
  double begin = 0, length = 0;  ///< in the ray's t

  Vec3 at(double s) const { return origin + s * step; }
  double t(double s) const { return begin + s * length; }
};

/// Where along a stretch the ray goes through the surface, in order.
struct StretchRoots {
  static constexpr std::size_t kMost = 32;
  std::size_t count = 0;
  std::array<double, kMost> s{};
  std::array<double, kMost> slope{};  ///< of the gauge by s
  bool starts_inside = false;

  void add(double at, double steepness) {
    if (count == kMost) return;
    s[count] = at;
    slope[count++] = steepness;
  }
};

}  // namespace dioptre
