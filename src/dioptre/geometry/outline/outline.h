// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dioptre/core/vec.h"
#include "dioptre/geometry/outline/bernstein.h"

namespace dioptre {

/// A piece of an outline: a Bezier curve of degree 1, 2 or 3 with degree + 1 control points. It
/// begins at points[0] and ends at points[degree].
struct Curve {
  std::array<Vec2, 4> points{};
  int degree = 1;

  Vec2 begin() const { return points[0]; }
  Vec2 end() const { return points[static_cast<std::size_t>(degree)]; }
  /// The point at s in [0,1].
  Vec2 at(double s) const;
  /// The derivative by s; where it vanishes (a control point on an end), a direction along the
  /// curve there. Zero only for a curve that is a point.
  Vec2 tangent(double s) const;
};

Curve line(Vec2 a, Vec2 b);
Curve quadratic(Vec2 a, Vec2 b, Vec2 c);
Curve cubic(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// A box in the plane.
struct PlaneBounds {
  Vec2 min{1e308, 1e308}, max{-1e308, -1e308};
  void add(Vec2 p);
};

/// A directed line in the plane: where dot(normal, p - anchor) = 0. The normal is of any length.
struct PlaneLine {
  Vec2 anchor, normal;
  double anchor_error = 0;  ///< how far the anchor may be from where it should be

  double side(Vec2 p) const { return dot(normal, p - anchor); }
};

/// Where a line goes through an outline.
struct OutlineCrossing {
  std::uint32_t curve = 0;
  double s = 0;        ///< where on the curve
  double s_error = 0;  ///< a bound on the error of s
  int winding = 0;     ///< +1 if the curve goes to the line's positive side, else -1
};

/// Closed curves in the plane, as a list of pieces; each loop's pieces join at equal points.
///
/// The crossings of any line have an even number and windings that sum to 0, whatever the
/// rounding: the side of a shared point is computed once and the same for both its curves.
class Outline {
 public:
  /// Starts a new loop; the one before is closed by a straight line if it is open.
  void move_to(Vec2 p);
  /// Appends a curve that begins where the last one ended.
  void add(const Curve& curve);
  /// Closes the last loop.
  void close();

  const std::vector<Curve>& curves() const { return curves_; }
  const PlaneBounds& bounds() const { return bounds_; }

  /// Calls sink(const OutlineCrossing&) for each crossing, in the order of the curves.
  template <class Sink>
  void cross(const PlaneLine& line, Sink&& sink) const {
    for (std::uint32_t i = 0; i < curves_.size(); ++i) cross_curve(line, i, sink);
  }
  /// The winding number around p.
  int winding(Vec2 p) const;
  /// The number of curves right of p, by parity: the even-odd rule.
  bool contains_even_odd(Vec2 p) const { return winding_and_parity(p).odd; }

 private:
  struct Around {
    int winding = 0;
    bool odd = false;
  };
  Around winding_and_parity(Vec2 p) const;

  template <class Sink>
  void cross_curve(const PlaneLine& line, std::uint32_t index, Sink&& sink) const {
    const Curve& c = curves_[index];
    const double a = line.side(c.points[0]), b = line.side(c.points[1]);
    if (c.degree == 1) {
      report<1>(line, index, {a, b}, sink);
    } else if (c.degree == 2) {
      report<2>(line, index, {a, b, line.side(c.points[2])}, sink);
    } else {
      report<3>(line, index, {a, b, line.side(c.points[2]), line.side(c.points[3])}, sink);
    }
  }
  template <std::size_t N, class Sink>
  void report(const PlaneLine& line, std::uint32_t index, const Bernstein<N>& side,
              Sink&& sink) const {
    if (keeps_sign<N>(side)) return;
    const SignChanges<N> changes = sign_changes<N>(side);
    for (std::size_t i = 0; i < changes.count; ++i) {
      const double s = changes.at[i].s;
      sink(OutlineCrossing{index, s, parameter_error(line, curves_[index], s),
                           changes.at[i].rises ? 1 : -1});
    }
  }
  static double parameter_error(const PlaneLine& line, const Curve& curve, double s);

  std::vector<Curve> curves_;
  PlaneBounds bounds_;
  Vec2 start_;
  bool open_ = false;
};

}  // namespace dioptre
