// SPDX-License-Identifier: Apache-2.0
// vturbulence: noise belongs to the renderer, so the vector is read off a pattern that it moves.
#include <cmath>

#include "dioptre/io/pov/interpreter.h"

namespace dioptre::pov {
namespace {

/// Small enough that a moved point stays within half a period of the gradient.
constexpr double kAmount = 0.125;
/// The gradient is moved along so that its values are those of positive places.
constexpr double kShift = 16384;

Pattern moved_gradient(Vec3 axis, const Turbulence& turbulence) {
  Pattern pattern;
  pattern.data = Gradient{axis};
  pattern.warps = {TransformWarp{translation(-kShift * axis)}, turbulence};
  return pattern;
}

}  // namespace

Numeric Interpreter::turbulence_vector() {
  Turbulence turbulence;
  turbulence.amount = {kAmount, kAmount, kAmount};
  turbulence.lambda = float_argument();
  expect(',', "between the arguments");
  turbulence.omega = float_argument();
  expect(',', "between the arguments");
  const double octaves = float_argument();
  turbulence.octaves = octaves >= 10 ? 10 : octaves >= 1 ? static_cast<std::uint32_t>(octaves) : 1;
  expect(',', "between the arguments");
  const Vec3 point = vector_argument();
  const std::array<double, 3> key{turbulence.lambda, turbulence.omega,
                                  static_cast<double>(turbulence.octaves)};
  auto [known, made] = turbulences_.try_emplace(key);
  for (std::size_t i = 0; made && i < 3; ++i) {
    Vec3 axis;
    axis[i] = 1;
    known->second[i] = add_function("vturbulence", {"x", "y", "z"},
                                    PatternFunction{moved_gradient(axis, turbulence)});
  }
  const double place[] = {point.x, point.y, point.z};
  Vec3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    const double moved = queries().call(scene_, known->second[i], place);
    const double by = moved - (place[i] - std::floor(place[i]));
    result[i] = (by - std::round(by)) / kAmount;
  }
  return vector3(result);
}

}  // namespace dioptre::pov
