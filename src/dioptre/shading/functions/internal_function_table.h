// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

namespace dioptre {

/// The value of built-in function `number` (as functions.inc numbers them); arguments beyond those
/// given count as 0; unknown numbers give 0.
double internal_function(std::uint32_t number, std::span<const double> arguments);

/// How many arguments built-in function `number` takes, x, y and z among them; 0 when unknown.
std::uint32_t internal_parameter_count(std::uint32_t number);

}  // namespace dioptre
