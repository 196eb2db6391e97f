// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/vec.h"
#include "dioptre/scene/pattern.h"

namespace dioptre {

/// The profile of a quilt: a cubic Bezier curve from 0 to 1 with the quilt's two controls, at a
/// distance from the centre of a unit cube.
double quilted_curve(double distance, const Quilted& quilted);

/// The pattern's value, 0 to 1: for q from the centre of a unit cube
/// (2 / (3 sqrt 3)) (|q.x| + |q.y| + |q.z|) curve(|q|) (measured).
double quilted_value(Vec3 p, const Quilted& quilted);

}  // namespace dioptre
