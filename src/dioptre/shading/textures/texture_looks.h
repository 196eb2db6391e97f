// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/shading/textures/texture_table.h"

namespace dioptre {

/// Makes one texture ready, its own transform included.
std::unique_ptr<const TextureLook> make_texture_look(const Texture& texture,
                                                     const TextureTable& table,
                                                     const TextureParts& parts,
                                                     const PatternServices& services);

}  // namespace dioptre
