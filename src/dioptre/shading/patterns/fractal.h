// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/vec.h"
#include "dioptre/scene/pattern.h"

namespace dioptre {

/// The value of a Mandelbrot, Julia or magnet fractal at a point of the x-y plane, coloured by its
/// exterior and interior types (0 one; 1 iterations or the smallest modulus; 2 to 6 real part,
/// imaginary part, their squares and the modulus at the end; 7, 8 iterations modulo the factor).
double fractal_value(Vec3 p, const Fractal& fractal);

}  // namespace dioptre
