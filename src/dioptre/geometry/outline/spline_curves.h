// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dioptre/core/result.h"
#include "dioptre/core/vec.h"
#include "dioptre/geometry/outline/outline.h"
#include "dioptre/geometry/outline/outline_spline.h"

namespace dioptre {

/// Refuses control points that make no curve: too few of them, groups of a Bezier spline that are
/// not whole, numbers that are not finite. The message begins with the shape's name.
Result<void> check_points(const char* shape, OutlineSpline spline, const std::vector<Vec2>& points,
                          bool closed);

/// The curves that control points stand for, in order. Each begins where the last one ended, but
/// for groups of a Bezier spline that do not.
std::vector<Curve> spline_curves(OutlineSpline spline, const std::vector<Vec2>& points);

}  // namespace dioptre
