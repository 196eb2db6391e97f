// SPDX-License-Identifier: Apache-2.0
// Built-in functions as formulas, so that bounds of them are known (see field_shapes.cpp for the
// same in numbers).
#include "dioptre/shading/functions/program_builder.h"
#include "dioptre/shading/noise/noise.h"

namespace dioptre {
namespace {

using Code = Step::Code;

enum Number : std::uint32_t {
  kEllipsoid = 17,
  kPolarAngle = 47,
  kRadius = 57,
  kRoundedBox = 60,
  kSphere = 61,
  kAzimuth = 69,
  kTorus = 70,
  kNoise = 76,
  kNoiseOfGenerator = 78,
};

}  // namespace

ProgramBuilder::Value ProgramBuilder::norm(Value x, Value y) {
  return apply(Code::kSqrt, apply(Code::kAdd, squared(x), squared(y)));
}

ProgramBuilder::Value ProgramBuilder::norm(Value x, Value y, Value z) {
  const Value flat = apply(Code::kAdd, squared(x), squared(y));
  return apply(Code::kSqrt, apply(Code::kAdd, flat, squared(z)));
}

ProgramBuilder::Value ProgramBuilder::noise(Value x, Value y, Value z, std::uint32_t generator) {
  return add({Kind::kNoise, Code::kCall, {x, y, z}, generator});
}

ProgramBuilder::Value ProgramBuilder::rounded_box(std::span<const Value> a) {
  const auto outside = [&](std::size_t axis) {
    const Value inner = apply(Code::kSubtract, a[4 + axis], a[3]);
    const Value beyond = apply(Code::kSubtract, apply(Code::kAbs, a[axis]), inner);
    return apply(Code::kMax, beyond, constant(0));
  };
  const Value distance = norm(outside(0), outside(1), outside(2));
  constexpr double kMargin = 1e-6;
  return apply(Code::kSubtract, apply(Code::kSubtract, distance, a[3]), constant(kMargin));
}

std::optional<ProgramBuilder::Value> ProgramBuilder::internal(std::uint32_t number,
                                                              std::span<const Value> arguments) {
  std::vector<Value> a(arguments.begin(), arguments.end());
  while (a.size() < 7) a.push_back(constant(0));
  switch (number) {
    case kEllipsoid:
      return norm(apply(Code::kMultiply, a[0], a[3]), apply(Code::kMultiply, a[1], a[4]),
                  apply(Code::kMultiply, a[2], a[5]));
    case kPolarAngle:
      return apply(Code::kAtan2, norm(a[0], a[2]), a[1]);
    case kRadius:
      return norm(a[0], a[1], a[2]);
    case kRoundedBox:
      return rounded_box(a);
    case kSphere:
      return apply(Code::kSubtract, norm(a[0], a[1], a[2]), a[3]);
    case kAzimuth:
      return apply(Code::kAtan2, a[0], a[2]);
    case kTorus:
      return apply(Code::kSubtract, norm(apply(Code::kSubtract, norm(a[0], a[2]), a[3]), a[1]),
                   a[4]);
    case kNoise:
      return noise(a[0], a[1], a[2], static_cast<std::uint32_t>(NoiseGenerator::kRangeCorrected));
    case kNoiseOfGenerator: {
      const auto generator = known(a[3]);
      if (generator != 1.0 && generator != 2.0 && generator != 3.0) return std::nullopt;
      return noise(a[0], a[1], a[2], static_cast<std::uint32_t>(*generator));
    }
    default:
      return std::nullopt;
  }
}

}  // namespace dioptre
