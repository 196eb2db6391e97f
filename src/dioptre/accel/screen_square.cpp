// SPDX-License-Identifier: Apache-2.0
#include "dioptre/accel/screen_square.h"

#include <algorithm>
#include <cmath>

#include "dioptre/core/interval.h"

namespace dioptre {
namespace {

/// What a position may be wrong by through rounding, on a screen from -1 to 1, and more.
constexpr double kMargin = 0x1p-40;

/// The positions that x / w takes for x in `across` and w in `depth`, where depth.max > 0 and only
/// w > 0 counts.
Interval perspective(Interval across, Interval depth) {
  const auto divide = [&depth](double x, bool far) {
    if (far) return x / depth.max;
    return depth.min > 0 ? x / depth.min : std::copysign(kInfinity, x);
  };
  return {divide(across.min, across.min >= 0), divide(across.max, across.max <= 0)};
}

}  // namespace

ScreenPoint pierce(Vec3 direction) {
  const Vec3 size = abs(direction);
  const std::size_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  return {2 * axis + (direction[axis] > 0 ? 1 : 0), direction[(axis + 1) % 3] / size[axis],
          direction[(axis + 2) % 3] / size[axis]};
}

ScreenRectangle project(const Bounds& seen, std::size_t screen, std::size_t side) {
  const ScreenRectangle nothing{{0, 0}, {-1, -1}};
  if (seen.contains({0, 0, 0})) {
    const auto last = static_cast<std::ptrdiff_t>(side) - 1;
    return {{0, 0}, {last, last}};
  }
  const std::size_t axis = screen / 2;
  const Interval depth = screen % 2 == 1 ? Interval{seen.min[axis], seen.max[axis]}
                                         : Interval{-seen.max[axis], -seen.min[axis]};
  if (!(depth.max > 0)) return nothing;
  ScreenRectangle rectangle{};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t along = (axis + 1 + i) % 3;
    const Interval covered = perspective({seen.min[along], seen.max[along]}, depth);
    if (!(covered.min <= 1 + kMargin && covered.max >= -1 - kMargin)) return nothing;
    rectangle.first[i] = static_cast<std::ptrdiff_t>(square_of(covered.min - kMargin, side));
    rectangle.last[i] = static_cast<std::ptrdiff_t>(square_of(covered.max + kMargin, side));
  }
  return rectangle;
}

std::size_t square_of(double position, std::size_t side) {
  const double squares = static_cast<double>(side);
  return static_cast<std::size_t>(
      std::clamp(std::floor((position + 1) * 0.5 * squares), 0.0, squares - 1));
}

}  // namespace dioptre
