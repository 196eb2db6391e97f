// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "dioptre/scene/scene.h"

namespace dioptre {

/// Looks for a texture, pigment, normal, function or solid whose value needs itself, through
/// whatever chain. Empty if there is none, else the JSON pointer of one on the cycle and what is
/// wrong. All ids must be in range.
std::string find_cycle(const Scene& scene);

}  // namespace dioptre
