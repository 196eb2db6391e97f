// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "dioptre/core/expression.h"
#include "dioptre/core/interval_jet.h"

namespace dioptre {

/// A number for every point: of space (three arguments x, y, z) or of a surface's parameters (two
/// arguments u, v). Immutable, shared by threads; no call allocates after warm-up.
class ScalarField {
 public:
  virtual ~ScalarField() = default;

  /// The value; missing arguments are 0. Total: NaN where there is none.
  virtual double value(std::span<const double> arguments) const = 0;

  /// Bounds of the value, and of its slope, where the arguments are themselves functions of one
  /// number t over a stretch. Along a ray, x is {[x0, x1], [dx, dx]}; over a rectangle, u is
  /// {[u0, u1], [1, 1]} and v is {[v0, v1], [0, 0]} for the slope by u. Never too narrow: it is
  /// everything where nothing is known.
  virtual IntervalJet range(std::span<const IntervalJet> arguments) const = 0;
};

/// Where prepared shapes get the functions of their descriptions from.
class ScalarFields {
 public:
  virtual ~ScalarFields() = default;
  /// The field of a function; it must not be used when this source is gone. None for no function.
  virtual std::unique_ptr<const ScalarField> field(Id<Function> function) const = 0;
};

}  // namespace dioptre
