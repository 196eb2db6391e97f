// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "dioptre/core/vec.h"

namespace dioptre {

/// A built-in function of a point and further parameters p[0], p[1], ... .
struct InternalFunctionBody {
  double (*value)(Vec3 point, const double* p) = nullptr;
};

/// The most parameters that a built-in function takes beside x, y, z.
inline constexpr std::size_t kMostInternalParameters = 10;

/// The built-in function with a number of functions.inc. One that has no formula here is 0
/// everywhere; see has_internal_function.
InternalFunctionBody internal_function(std::uint32_t number);

/// True if the built-in function with that number can be evaluated.
bool has_internal_function(std::uint32_t number);

/// Calls a built-in function with x, y, z and its parameters; missing ones are 0.
double call_internal(const InternalFunctionBody& function, std::span<const double> arguments);

}  // namespace dioptre
