// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/functions/internal_functions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "dioptre/shading/noise/noise.h"

namespace dioptre {
namespace {

constexpr std::uint32_t kCount = 79;

using Value = double (*)(Vec3, const double*);
using Table = std::array<Value, kCount>;

constexpr Table make_table() {
  Table table{};
  table[57] = [](Vec3 v, const double*) { return length(v); };
  table[61] = [](Vec3 v, const double* p) { return length(v) - p[0]; };
  table[70] = [](Vec3 v, const double* p) {
    return std::hypot(std::hypot(v.x, v.z) - p[0], v.y) - p[1];
  };
  table[76] = [](Vec3 v, const double*) { return noise(v, NoiseGenerator::kRangeCorrected); };
  table[78] = [](Vec3 v, const double* p) {
    return noise(v, p[0] == 1   ? NoiseGenerator::kOriginal
                    : p[0] == 3 ? NoiseGenerator::kPerlin
                                : NoiseGenerator::kRangeCorrected);
  };
  return table;
}

constexpr Table kTable = make_table();

}  // namespace

bool has_internal_function(std::uint32_t number) { return number < kCount && kTable[number]; }

InternalFunctionBody internal_function(std::uint32_t number) {
  return {number < kCount ? kTable[number] : nullptr};
}

double call_internal(const InternalFunctionBody& function, std::span<const double> arguments) {
  if (!function.value) return 0;
  double all[3 + kMostInternalParameters] = {};
  std::copy_n(arguments.begin(), std::min(arguments.size(), std::size(all)), all);
  return function.value({all[0], all[1], all[2]}, all + 3);
}

}  // namespace dioptre
