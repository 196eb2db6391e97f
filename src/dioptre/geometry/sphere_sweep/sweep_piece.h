// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "dioptre/core/bounds.h"
#include "dioptre/core/result.h"
#include "dioptre/geometry/sphere_sweep/sphere_sweep.h"

namespace dioptre {

/// A piece of a sweep: centre and radius as Bezier curves of degree 1 or 3. Pieces that follow each
/// other share their end sphere, to the last bit.
struct SweepPiece {
  int degree = 1;
  std::array<Vec3, 4> center{};
  std::array<double, 4> radius{};
  Vec3 ball_center;  ///< of a ball that holds the piece
  double ball_radius = 0;

  Vec3 center_at(double s) const;
  double radius_at(double s) const;
  Bounds bounds() const;
};

/// The pieces of a sweep; cubic segments are cut into shorter ones, which a ray misses more often.
Result<std::vector<SweepPiece>> sweep_pieces(const SphereSweep& sweep);

}  // namespace dioptre
