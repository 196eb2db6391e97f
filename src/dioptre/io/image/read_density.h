// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "dioptre/core/result.h"
#include "dioptre/scene/density_grid.h"

namespace dioptre {

/// The values of a df3 file from all its bytes: three sizes of 16 bits, then values of 8, 16 or 32
/// bits by the length of the file, all with the high byte first, scaled to [0, 1]. An error if the
/// file is empty or too short; what is left over at its end does not matter.
Result<DensityGrid> decode_density(std::string_view bytes);

}  // namespace dioptre
