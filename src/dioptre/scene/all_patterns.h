// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dioptre/scene/scene.h"

namespace dioptre {

/// Every pattern of the scene, wherever it is used, in a fixed order. The pointers live as long as
/// the scene is not changed.
std::vector<const Pattern*> all_patterns(const Scene& scene);

}  // namespace dioptre
