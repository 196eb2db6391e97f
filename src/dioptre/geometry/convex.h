// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "dioptre/geometry/shape.h"

namespace dioptre {

/// The rounding unit of double arithmetic, the base of all error bounds.
inline constexpr double kRounding = 0x1p-53;

/// The stretch of a ray inside a convex solid. An end at infinity is no crossing.
struct ConvexSpan {
  struct End {
    double t;
    double error = 0;
    std::uint32_t face = 0;
    bool visible = true;
  };
  End enter{-kInfinity}, exit{kInfinity};
  Interval wanted = Interval::all();  ///< set by the caller: where the span matters

  /// Cuts the span to the part inside one more convex set.
  void clip_enter(double t, double error, std::uint32_t face, bool visible = true) {
    if (t > enter.t) enter = {t, error, face, visible};
  }
  void clip_exit(double t, double error, std::uint32_t face, bool visible = true) {
    if (t < exit.t) exit = {t, error, face, visible};
  }
  bool empty() const { return !(enter.t < exit.t); }

  Crossing entry() const { return crossing(enter, true); }
  Crossing leaving() const { return crossing(exit, false); }

 private:
  static Crossing crossing(const End& end, bool entering) {
    return {.t = end.t,
            .error = end.error,
            .face = end.face,
            .entering = entering,
            .visible = end.visible};
  }
};

/// A solid that every ray meets in one stretch or not at all.
class ConvexSolid : public Shape {
 public:
  double cost() const override { return 1; }

  /// The stretch of a ray inside; false, and `out` is undefined, for a miss.
  virtual bool stretch(const Ray& ray, ConvexSpan& out) const = 0;
};

/// A convex solid: `Derived` has `bool span(const Ray&, ConvexSpan&) const`, false for a miss; a
/// span with no part in the wanted range may count as one.
template <class Derived>
class ConvexShape : public ConvexSolid {
 public:
  bool stretch(const Ray& ray, ConvexSpan& out) const final {
    return derived().span(ray, out) && !out.empty();
  }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const final {
    ConvexSpan s{.wanted = range};
    if (!derived().span(ray, s) || s.empty()) return false;
    if (range.surrounds(s.enter.t)) out.push_back(s.entry());
    if (range.surrounds(s.exit.t)) out.push_back(s.leaving());
    return s.enter.t <= range.min && range.min < s.exit.t;
  }

  bool nearest(const Ray& ray, Interval range, Crossing& out) const final {
    ConvexSpan s{.wanted = range};
    if (!derived().span(ray, s) || s.empty()) return false;
    if (range.surrounds(s.enter.t) && s.enter.visible) {
      out = s.entry();
    } else if (range.surrounds(s.exit.t) && s.exit.visible) {
      out = s.leaving();
    } else {
      return false;
    }
    return true;
  }

 private:
  const Derived& derived() const { return static_cast<const Derived&>(*this); }
};

}  // namespace dioptre
