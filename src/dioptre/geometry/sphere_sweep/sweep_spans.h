// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/interval.h"
#include "dioptre/geometry/sphere_sweep/sweep_piece.h"

namespace dioptre {

/// One end of a span: the distance along the ray, and the place on the piece of the sphere that
/// the surface touches there.
struct SpanEnd {
  double distance = 0;
  double s = 0;
};

/// A stretch of a ray inside one piece of a sweep.
struct SweepSpan {
  SpanEnd enter{kInfinity, 0}, exit{-kInfinity, 0};
};

/// At most this many spans: the squared half chord has degree 6.
inline constexpr std::size_t kMostSweepSpans = 4;

struct SweepSpans {
  std::size_t count = 0;
  std::array<SweepSpan, kMostSweepSpans> at{};
};

/// The spans of a line with a piece. The line is given by a point and three unit vectors at right
/// angles, the first along it.
///
/// The sphere at s cuts the line between b(s) - w(s) and b(s) + w(s), where b is the centre's
/// place along the line and w^2 = r^2 - (the centre's distance from the line)^2. Where w^2 >= 0 on
/// a stretch of s, these intervals change continuously, so their union is one interval: from the
/// least b - w to the greatest b + w. They lie where b' = +-w', or b'^2 w^2 = (w w')^2: a
/// polynomial of degree 10 for a cubic path.
SweepSpans sweep_spans(const SweepPiece& piece, Vec3 origin, const std::array<Vec3, 3>& axes);

/// Whether a point is inside one of the piece's spheres.
bool inside_piece(const SweepPiece& piece, Vec3 p);

}  // namespace dioptre
