// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/sphere_sweep/sweep_piece.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "dioptre/geometry/outline/bernstein.h"

namespace dioptre {
namespace {

using Sphere = SphereSweep::Sphere;

Sphere operator+(const Sphere& a, const Sphere& b) {
  return {a.center + b.center, a.radius + b.radius};
}
Sphere operator-(const Sphere& a, const Sphere& b) {
  return {a.center - b.center, a.radius - b.radius};
}
Sphere operator*(double s, const Sphere& a) { return {s * a.center, s * a.radius}; }

using Cubic = std::array<Sphere, 4>;

SweepPiece piece_of(const std::array<Sphere, 4>& controls, int degree) {
  SweepPiece piece;
  piece.degree = degree;
  for (std::size_t i = 0; i < 4; ++i) {
    piece.center[i] = controls[i].center;
    piece.radius[i] = controls[i].radius;
  }
  const std::size_t count = static_cast<std::size_t>(degree) + 1;
  Bounds centers;
  for (std::size_t i = 0; i < count; ++i) centers = unite(centers, piece.center[i]);
  piece.ball_center = centers.center();
  for (std::size_t i = 0; i < count; ++i) {
    const double reach = length(piece.center[i] - piece.ball_center) + std::fabs(piece.radius[i]);
    piece.ball_radius = std::max(piece.ball_radius, reach);
  }
  return piece;
}

/// Cuts at the middle (de Casteljau) `depth` times over.
void add_halves(const Cubic& c, int depth, std::vector<SweepPiece>& pieces) {
  if (depth == 0) {
    pieces.push_back(piece_of(c, 3));
    return;
  }
  const auto middle = [](const Sphere& a, const Sphere& b) { return 0.5 * (a + b); };
  const Sphere ab = middle(c[0], c[1]), bc = middle(c[1], c[2]), cd = middle(c[2], c[3]);
  const Sphere abc = middle(ab, bc), bcd = middle(bc, cd), abcd = middle(abc, bcd);
  add_halves({c[0], ab, abc, abcd}, depth - 1, pieces);
  add_halves({abcd, bcd, cd, c[3]}, depth - 1, pieces);
}

Cubic b_spline(const Sphere& a, const Sphere& b, const Sphere& c, const Sphere& d) {
  return {(1.0 / 6) * (a + 4 * b + c), (1.0 / 3) * (2 * b + c), (1.0 / 3) * (b + 2 * c),
          (1.0 / 6) * (b + 4 * c + d)};
}

Cubic catmull_rom(const Sphere& a, const Sphere& b, const Sphere& c, const Sphere& d) {
  return {b, b + (1.0 / 6) * (c - a), c - (1.0 / 6) * (d - b), c};
}

Result<void> check(const SphereSweep& sweep) {
  const std::size_t least = sweep.spline == SphereSweepSpline::kLinear ? 2 : 4;
  if (sweep.spheres.size() < least) {
    return fail("sphere_sweep needs at least " + std::to_string(least) + " spheres, found " +
                std::to_string(sweep.spheres.size()));
  }
  constexpr double kLargest = 1e150;  // squares stay finite
  for (const Sphere& s : sweep.spheres) {
    if (!(max_component(abs(s.center)) < kLargest) || !(std::fabs(s.radius) < kLargest) ||
        !is_finite(s.center)) {
      return fail("sphere_sweep has a number that is not finite, or too large");
    }
  }
  return {};
}

/// The largest value of a polynomial on [0, 1].
template <std::size_t N>
double largest(const Bernstein<N>& b) {
  double most = std::max(b[0], b[N]);
  if constexpr (N > 1) {
    Bernstein<N - 1> steps;
    for (std::size_t i = 0; i < N; ++i) steps[i] = b[i + 1] - b[i];
    const SignChanges<N - 1> turns = sign_changes<N - 1>(steps);
    const PowerBasis<N> power(b);
    for (std::size_t i = 0; i < turns.count; ++i) {
      most = std::max(most, power.value(turns.at[i].s));
    }
  }
  return most;
}

}  // namespace

Vec3 SweepPiece::center_at(double s) const {
  const double r = 1 - s;
  if (degree == 1) return r * center[0] + s * center[1];
  return r * r * r * center[0] + 3 * r * r * s * center[1] + 3 * r * s * s * center[2] +
         s * s * s * center[3];
}

double SweepPiece::radius_at(double s) const {
  const double r = 1 - s;
  if (degree == 1) return r * radius[0] + s * radius[1];
  return r * r * r * radius[0] + 3 * r * r * s * radius[1] + 3 * r * s * s * radius[2] +
         s * s * s * radius[3];
}

Bounds SweepPiece::bounds() const {
  Bounds box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // How far the spheres of radius |r| reach: centre + r and centre - r, upwards and downwards.
    const auto reach = [&](double direction, double side) {
      const auto at = [&](std::size_t i) { return direction * center[i][axis] + side * radius[i]; };
      return degree == 1 ? largest<1>({at(0), at(1)}) : largest<3>({at(0), at(1), at(2), at(3)});
    };
    const double slack = 1e-12 * (ball_radius + std::fabs(ball_center[axis]));
    box.max[axis] = std::max(reach(1, 1), reach(1, -1)) + slack;
    box.min[axis] = -std::max(reach(-1, 1), reach(-1, -1)) - slack;
  }
  return box;
}

Result<std::vector<SweepPiece>> sweep_pieces(const SphereSweep& sweep) {
  if (auto checked = check(sweep); !checked) return tl::unexpected<Error>(checked.error());
  const std::vector<Sphere>& p = sweep.spheres;
  std::vector<SweepPiece> pieces;
  if (sweep.spline == SphereSweepSpline::kLinear) {
    for (std::size_t i = 1; i < p.size(); ++i) pieces.push_back(piece_of({p[i - 1], p[i]}, 1));
    return pieces;
  }
  constexpr int kHalvings = 1;
  for (std::size_t i = 0; i + 3 < p.size(); ++i) {
    const bool b = sweep.spline == SphereSweepSpline::kBSpline;
    add_halves((b ? b_spline : catmull_rom)(p[i], p[i + 1], p[i + 2], p[i + 3]), kHalvings, pieces);
  }
  return pieces;
}

}  // namespace dioptre
