// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/vec.h"
#include "dioptre/scene/pattern.h"

namespace dioptre {

/// The value of a density file, which fills the unit cube [0, 1)^3; 0 outside. With n values along
/// an axis, value i stands at i / n (measured):
/// - interpolation 0: that of the value before the point,
/// - 1: linear between the value before and the one behind it, the first following the last,
/// - 2: cubic convolution (R. Keys, "Cubic Convolution Interpolation for Digital Image Processing",
///   1981, a = -1/2) of two values on each side; before the first value comes number
///   2^64 - 1 modulo n. A value below 0 counts as 0; one above 1 stays.
double density_value(Vec3 p, const DensityFile& file);

}  // namespace dioptre
