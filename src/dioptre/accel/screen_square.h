// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "dioptre/core/bounds.h"

namespace dioptre {

/// The six screens around an eye: faces of the cube from -1 to 1, two for each axis. Screen 2 a is
/// at -1 along axis a and screen 2 a + 1 at 1, and positions on it are along the other two axes.
struct ScreenPoint {
  std::size_t screen;
  double u, v;
};

/// Where a direction, which must be finite and not zero, pierces the screens.
ScreenPoint pierce(Vec3 direction);

/// A rectangle of squares on a screen of `side` times `side`; empty if last is before first.
struct ScreenRectangle {
  std::array<std::ptrdiff_t, 2> first, last;
  bool empty() const { return last[0] < first[0] || last[1] < first[1]; }
  std::size_t size() const {
    if (empty()) return 0;
    return static_cast<std::size_t>(last[0] - first[0] + 1) *
           static_cast<std::size_t>(last[1] - first[1] + 1);
  }
};

/// The squares of a screen that a box, given relative to the eye, may cover.
ScreenRectangle project(const Bounds& seen, std::size_t screen, std::size_t side);

/// The square of a position from -1 to 1 on a screen's axis.
std::size_t square_of(double position, std::size_t side);

}  // namespace dioptre
