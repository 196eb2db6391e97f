// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/result.h"
#include "dioptre/geometry/outline/outline.h"
#include "dioptre/geometry/prism/prism.h"

namespace dioptre {

/// The curves that a prism's control points stand for.
Result<Outline> prism_outline(const Prism& prism);

}  // namespace dioptre
