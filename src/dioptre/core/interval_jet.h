// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/expression.h"
#include "dioptre/core/interval_math.h"

namespace dioptre {

/// What is known of a function g of one number t over a stretch of it: `value` holds g(t) for all t
/// in the stretch, and `slope` holds (g(s) - g(t)) / (s - t) for any two of them, which by the mean
/// value theorem the derivative does (A. Neumaier, "Interval Methods for Systems of Equations",
/// 1990). Everything where nothing is known: g may then jump, or have no value at places.
struct IntervalJet {
  Interval value = Interval::all();
  Interval slope = Interval::all();

  static IntervalJet constant(double v) { return {interval_of(v), {0, 0}}; }
  static IntervalJet everything() { return {}; }
};

/// The jet of a step of one or two operands (as evaluate_operator has it for numbers), whose jets
/// are a and b. Total: everything where it cannot tell.
IntervalJet evaluate_operator(Step::Code code, const IntervalJet& a, const IntervalJet& b);

/// The jet of Step::Code::kSelect by the sign of a.
IntervalJet select(const IntervalJet& a, const IntervalJet& negative, const IntervalJet& zero,
                   const IntervalJet& positive);

/// The jet of sqrt(x^2 + y^2 + z^2), which is nowhere steeper than (x, y, z) moves.
IntervalJet norm(const IntervalJet& x, const IntervalJet& y, const IntervalJet& z);

}  // namespace dioptre
