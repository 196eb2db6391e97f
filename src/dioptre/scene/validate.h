// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/result.h"
#include "dioptre/scene/scene.h"

namespace dioptre {

/// Checks what everything that works on a scene relies on, and what a hand-written or damaged scene
/// may lack: every id is none or in range (and there where it must be), parts come before their
/// wholes, nothing contains itself in any roundabout way, expressions refer to earlier steps,
/// transforms are finite. The error is a JSON pointer and the reason. Parameters of shapes are
/// checked when these are prepared.
Result<void> validate(const Scene& scene);

}  // namespace dioptre
