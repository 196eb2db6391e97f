// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "dioptre/core/vec.h"
#include "dioptre/geometry/shape.h"

namespace dioptre {

/// How four numbers <x, y, z, w> = x + y i + z j + w k are multiplied.
enum class JuliaAlgebra : std::uint8_t {
  kQuaternion,    ///< i j = k = -j i; ii = jj = kk = -1
  kHypercomplex,  ///< i j = k = j i; ii = jj = -1, kk = 1
};

/// What is iterated. Quaternions have the first two only; hypercomplex numbers have all others, and
/// take a cube for a square (measured).
enum class JuliaFunction : std::uint8_t {
  kSqr,
  kCube,
  kExp,
  kReciprocal,
  kSin,
  kAsin,
  kSinh,
  kAsinh,
  kCos,
  kAcos,
  kCosh,
  kAcosh,
  kTan,
  kAtan,
  kTanh,
  kAtanh,
  kLn,
  kPwr,  ///< to the power of `exponent`
};

/// The points h(0) of space whose h(k + 1) = f(h(k)) + parameter stay within a ball for k below
/// max_iteration: of radius 1 + |parameter| for quaternions, 4 for hypercomplex numbers (measured).
/// Space is the slice of all four dimensions where dot(h, slice_normal) = slice_distance |normal|:
/// <x, y, z> are the first three. (J. Hart, D. Sandin, L. Kauffman, "Ray tracing deterministic 3-D
/// fractals", 1989.)
struct JuliaFractal {
  static constexpr const char* kName = "julia_fractal";
  std::array<double, 4> parameter{1, 0, 0, 0};
  JuliaAlgebra algebra = JuliaAlgebra::kQuaternion;
  JuliaFunction function = JuliaFunction::kSqr;
  Vec2 exponent;  ///< a complex number
  std::uint32_t max_iteration = 20;
  double precision = 20;  ///< parts much smaller than 1 / precision may be missed
  std::array<double, 4> slice_normal{0, 0, 0, 1};  ///< the last one is not 0
  double slice_distance = 0;

  bool operator==(const JuliaFractal&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("parameter", self.parameter);
    visit("algebra", self.algebra);
    visit("function", self.function);
    visit("exponent", self.exponent);
    visit("max_iteration", self.max_iteration);
    visit("precision", self.precision);
    visit("slice_normal", self.slice_normal);
    visit("slice_distance", self.slice_distance);
  }
};

/// Checks the parameters. An error for a number that is not finite, a slice whose normal has no
/// fourth component, and a function that quaternions do not have.
Result<ShapePtr> prepare(const JuliaFractal& julia);

}  // namespace dioptre
