// SPDX-License-Identifier: Apache-2.0
#include "dioptre/core/interval_jet.h"

#include "dioptre/core/expression_eval.h"

namespace dioptre {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr Interval kNone{0, 0};
constexpr Interval kOne{1, 1};

bool is_constant(const IntervalJet& a) { return a.slope == kNone; }

/// Nothing is known of how it changes, unless the operands do not change at all.
IntervalJet with_jumps(Interval value, const IntervalJet& a, const IntervalJet& b) {
  if (is_point(value) || (is_constant(a) && is_constant(b))) return {value, kNone};
  return {value, Interval::all()};
}

/// f(a) with the values `value` and the derivatives `derivative` of f.
IntervalJet chain(const IntervalJet& a, Interval value, Interval derivative) {
  return {value, derivative * a.slope};
}

/// c a for a number c.
IntervalJet multiply(double c, const IntervalJet& a) {
  if (c > 0) {
    return {widen({c * a.value.min, c * a.value.max}), widen({c * a.slope.min, c * a.slope.max})};
  }
  return {widen({c * a.value.max, c * a.value.min}), widen({c * a.slope.max, c * a.slope.min})};
}

IntervalJet multiply(const IntervalJet& a, const IntervalJet& b) {
  if (is_constant(a) && is_point(a.value) && a.value.min != 0) return multiply(a.value.min, b);
  if (is_constant(b) && is_point(b.value) && b.value.min != 0) return multiply(b.value.min, a);
  return {a.value * b.value, a.value * b.slope + b.value * a.slope};
}

IntervalJet divide(const IntervalJet& a, const IntervalJet& b) {
  const Interval value = a.value / b.value;
  if (is_unbounded(value)) return IntervalJet::everything();
  return {value, (a.slope - value * b.slope) / b.value};
}

IntervalJet smaller(const IntervalJet& a, const IntervalJet& b) {
  if (a.value.max < b.value.min) return a;
  if (b.value.max < a.value.min) return b;
  return {{std::min(a.value.min, b.value.min), std::min(a.value.max, b.value.max)},
          unite(a.slope, b.slope)};
}

IntervalJet negate(const IntervalJet& a) { return {-a.value, -a.slope}; }

IntervalJet absolute(const IntervalJet& a) {
  if (a.value.min >= 0) return a;
  if (a.value.max <= 0) return negate(a);
  return {abs(a.value), unite(a.slope, -a.slope)};
}

IntervalJet square_root(const IntervalJet& a) {
  if (!(a.value.min >= 0)) return IntervalJet::everything();
  const Interval root = sqrt(a.value);
  const double steepest = root.min > 0 ? 0.5 / root.min : kInfinity;
  return chain(a, root, widen({0.5 / root.max, steepest}));
}

IntervalJet power(const IntervalJet& a, const IntervalJet& b) {
  const Interval value = pow(a.value, b.value);
  if (is_unbounded(value)) return IntervalJet::everything();
  if (is_constant(a) && is_constant(b)) return {value, kNone};
  const Interval by_base = b.value * pow(a.value, b.value - kOne);
  if (is_constant(b)) {
    if (!is_point(b.value)) return {value, by_base * a.slope};
    return {value, b.value * pow(a.value, interval_of(b.value.min - 1)) * a.slope};
  }
  if (!(a.value.min > 0)) return {value, Interval::all()};
  const Interval log = increasing(a.value, [](double v) { return std::log(v); });
  return {value, by_base * a.slope + value * log * b.slope};
}

IntervalJet angle(const IntervalJet& y, const IntervalJet& x) {
  const Interval value = atan2(y.value, x.value);
  const bool meets_cut = x.value.min <= 0 && y.value.min <= 0 && y.value.max >= 0;
  if (meets_cut) return with_jumps(value, y, x);
  const Interval squared = square(x.value) + square(y.value);
  if (!(squared.min > 0)) return {value, Interval::all()};
  return {value, (x.value / squared) * y.slope - (y.value / squared) * x.slope};
}

/// The remainder with the sign of a, which jumps where the quotient goes through a whole number.
IntervalJet remainder(const IntervalJet& a, const IntervalJet& b) {
  if (!is_point(b.value) || !is_constant(b) || b.value.min == 0 || is_unbounded(a.value)) {
    return IntervalJet::everything();
  }
  const double size = std::fabs(b.value.min);
  const double first = std::trunc(a.value.min / size), last = std::trunc(a.value.max / size);
  const bool one_piece = first == last && !(a.value.min < 0 && a.value.max > 0);
  const double slack = 1e-15 * (magnitude(a.value) + size);
  const double low = std::fmod(a.value.min, size), high = std::fmod(a.value.max, size);
  const bool sure = one_piece && low <= high && std::fabs(low) > slack &&
                    size - std::fabs(high) > slack && size - std::fabs(low) > slack &&
                    std::fabs(high) > slack;
  if (sure) return {widen({low, high}), a.slope};
  return with_jumps({a.value.min < 0 ? -size : 0, a.value.max > 0 ? size : 0}, a, b);
}

IntervalJet step_function(const IntervalJet& a, double (*f)(double)) {
  return with_jumps({f(a.value.min), f(a.value.max)}, a, a);
}

IntervalJet tangent(const IntervalJet& a) {
  const Interval cosine = cos(a.value);
  if (!(a.value.max - a.value.min < kPi) || !(cosine.min > 0 || cosine.max < 0)) {
    return with_jumps(Interval::all(), a, a);
  }
  const Interval value = increasing(a.value, [](double v) { return std::tan(v); });
  return chain(a, value, kOne + square(value));
}

/// 1 where surely true, 0 where surely false.
IntervalJet truth(bool sure, bool possible, const IntervalJet& a, const IntervalJet& b) {
  return with_jumps({sure ? 1.0 : 0.0, possible ? 1.0 : 0.0}, a, b);
}

IntervalJet compare(Step::Code code, const IntervalJet& a, const IntervalJet& b) {
  using C = Step::Code;
  const Interval p = a.value, q = b.value;
  const double reach = 2 * kEqualityTolerance;
  switch (code) {
    case C::kLess:
      return truth(p.max < q.min, p.min < q.max, a, b);
    case C::kLessEqual:
      return truth(p.max <= q.min, p.min <= q.max + reach, a, b);
    case C::kEqual:
      return truth(is_point(p) && p == q, p.min <= q.max + reach && q.min <= p.max + reach, a, b);
    default:
      return truth(p.min > q.max + reach || q.min > p.max + reach, !(is_point(p) && p == q), a, b);
  }
}

Interval truth_of(Interval a) {
  const bool sure = a.min >= kEqualityTolerance || a.max <= -kEqualityTolerance;
  const bool possible = !(a.min == 0 && a.max == 0);
  return {sure ? 1.0 : 0.0, possible ? 1.0 : 0.0};
}

IntervalJet logic(Step::Code code, const IntervalJet& a, const IntervalJet& b) {
  const Interval p = truth_of(a.value);
  if (code == Step::Code::kNot) return with_jumps({1 - p.max, 1 - p.min}, a, a);
  const Interval q = truth_of(b.value);
  if (code == Step::Code::kAnd) return with_jumps({p.min * q.min, p.max * q.max}, a, b);
  return with_jumps({std::max(p.min, q.min), std::max(p.max, q.max)}, a, b);
}

/// Functions that nowhere decrease, with the least and the greatest of their derivatives.
IntervalJet rise(Step::Code code, const IntervalJet& a) {
  using C = Step::Code;
  const Interval v = a.value;
  const auto image = [&](double (*f)(double)) { return increasing(v, f); };
  switch (code) {
    case C::kExp: {
      const Interval value = image(std::exp);
      return chain(a, value, value);
    }
    case C::kLn:
      if (!(v.min > 0)) return IntervalJet::everything();
      return chain(a, image(std::log), kOne / v);
    case C::kLog:
      if (!(v.min > 0)) return IntervalJet::everything();
      return chain(a, image(std::log10), widen(interval_of(0.43429448190325182765)) / v);
    case C::kSinh: {
      const Interval size = abs(v);
      return chain(a, image(std::sinh), increasing(size, [](double u) { return std::cosh(u); }));
    }
    case C::kTanh: {
      const Interval value = image(std::tanh);
      return chain(a, value, kOne - square(value));
    }
    case C::kAtan:
      return chain(a, image(std::atan), kOne / (kOne + square(v)));
    case C::kAsinh:
      return chain(a, image(std::asinh), kOne / sqrt(kOne + square(v)));
    case C::kAcosh:
      if (!(v.min > 1)) return IntervalJet::everything();
      return chain(a, image(std::acosh), kOne / sqrt(square(v) - kOne));
    default:
      if (!(v.min > -1 && v.max < 1)) return IntervalJet::everything();
      return chain(a, image(std::atanh), kOne / (kOne - square(v)));
  }
}

/// The angle whose sine or cosine is a.
IntervalJet inverse_wave(Step::Code code, const IntervalJet& a) {
  const Interval v = a.value;
  if (!(v.min >= -1 && v.max <= 1)) return IntervalJet::everything();
  const Interval value = code == Step::Code::kAsin
                             ? widen({std::asin(v.min), std::asin(v.max)}, kLibraryRoundings)
                             : widen({std::acos(v.max), std::acos(v.min)}, kLibraryRoundings);
  const Interval rest = kOne - square(v);
  if (!(rest.min > 0)) return with_jumps(value, a, a);
  const Interval derivative = kOne / sqrt(rest);
  return chain(a, value, code == Step::Code::kAsin ? derivative : -derivative);
}

}  // namespace

IntervalJet evaluate_operator(Step::Code code, const IntervalJet& a, const IntervalJet& b) {
  using C = Step::Code;
  switch (code) {
    case C::kAdd:
      return {a.value + b.value, a.slope + b.slope};
    case C::kSubtract:
      return {a.value - b.value, a.slope - b.slope};
    case C::kMultiply:
      return multiply(a, b);
    case C::kDivide:
      return divide(a, b);
    case C::kNegate:
      return negate(a);
    case C::kLess:
    case C::kLessEqual:
    case C::kEqual:
    case C::kNotEqual:
      return compare(code, a, b);
    case C::kGreater:
      return compare(C::kLess, b, a);
    case C::kGreaterEqual:
      return compare(C::kLessEqual, b, a);
    case C::kAnd:
    case C::kOr:
    case C::kNot:
      return logic(code, a, b);
    case C::kAbs:
      return absolute(a);
    case C::kAcos:
    case C::kAsin:
      return inverse_wave(code, a);
    case C::kCeil:
      return step_function(a, std::ceil);
    case C::kFloor:
      return step_function(a, std::floor);
    case C::kInt:
      return step_function(a, std::trunc);
    case C::kCos:
      return chain(a, cos(a.value), -sin(a.value));
    case C::kSin:
      return chain(a, sin(a.value), cos(a.value));
    case C::kTan:
      return tangent(a);
    case C::kCosh: {
      const Interval size = abs(a.value);
      const Interval slope = increasing(a.value, [](double v) { return std::sinh(v); });
      return chain(a, increasing(size, [](double v) { return std::cosh(v); }), slope);
    }
    case C::kDegrees:
    case C::kRadians:
      return multiply(a, {widen(interval_of(code == C::kDegrees ? 180 / kPi : kPi / 180)), kNone});
    case C::kAcosh:
    case C::kAsinh:
    case C::kAtan:
    case C::kAtanh:
    case C::kExp:
    case C::kLn:
    case C::kLog:
    case C::kSinh:
    case C::kTanh:
      return rise(code, a);
    case C::kSqrt:
      return square_root(a);
    case C::kAtan2:
      return angle(a, b);
    case C::kDiv:
      return step_function(divide(a, b), std::trunc);
    case C::kMin:
      return smaller(a, b);
    case C::kMax:
      return negate(smaller(negate(a), negate(b)));
    case C::kMod:
      return remainder(a, b);
    case C::kPow:
      return power(a, b);
    default:
      return IntervalJet::everything();
  }
}

IntervalJet select(const IntervalJet& a, const IntervalJet& negative, const IntervalJet& zero,
                   const IntervalJet& positive) {
  if (a.value.max < 0) return negative;
  if (a.value.min > 0) return positive;
  if (a.value.min == 0 && a.value.max == 0) return zero;
  Interval value = a.value.min <= 0 && a.value.max >= 0 ? zero.value : Interval{};
  if (a.value.min < 0) value = unite(value, negative.value);
  if (a.value.max > 0) value = unite(value, positive.value);
  return {value, Interval::all()};
}

IntervalJet norm(const IntervalJet& x, const IntervalJet& y, const IntervalJet& z) {
  const Interval value = sqrt(square(x.value) + square(y.value) + square(z.value));
  const Interval speed = sqrt(square(abs(x.slope)) + square(abs(y.slope)) + square(abs(z.slope)));
  const Interval steepest{-speed.max, speed.max};
  if (!(value.min > 0)) return {value, steepest};
  const Interval along = x.value * x.slope + y.value * y.slope + z.value * z.slope;
  const Interval slope = intersect(along / value, steepest);
  return {value, slope.empty() ? steepest : slope};
}

}  // namespace dioptre
