// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dioptre/core/result.h"
#include "dioptre/scene/scene.h"

namespace dioptre {

/// How many solids may lie within each other: deeper ones would need too much of a thread's stack.
constexpr std::uint32_t kDeepestSolid = 4000;

/// The number of levels of each object, itself included, appended for those that are not in
/// `levels` yet. Parts must come before their wholes.
void append_levels(const Scene& scene, std::vector<std::uint32_t>& levels);

/// Checks what everything that works on a scene relies on, and what a hand-written or damaged scene
/// may lack: every id is none or in range (and there where it must be), parts come before their
/// wholes and are not nested too deep, nothing contains itself in any roundabout way, expressions
/// refer to earlier steps, transforms are finite. The error is a JSON pointer and the reason.
/// Parameters of shapes are checked when these are prepared.
Result<void> validate(const Scene& scene);

}  // namespace dioptre
