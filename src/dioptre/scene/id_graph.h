// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "dioptre/scene/scene.h"

namespace dioptre {

/// Looks for a texture, pigment, normal, function or solid whose value needs itself, through
/// whatever chain. Empty if there is none, else the JSON pointer of one on the cycle and what is
/// wrong. All ids must be in range.
std::string find_cycle(const Scene& scene);

/// What a texture has to be told beside the point.
struct TextureNeeds {
  bool uv = false;       ///< surface coordinates
  bool surface = false;  ///< the normal and the direction of view
};

/// For each texture what it needs, through whatever it is made of; never less than it does. All ids
/// must be in range.
std::vector<TextureNeeds> texture_needs(const Scene& scene);

}  // namespace dioptre
