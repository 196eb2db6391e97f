// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dioptre {

/// The same GIF, BMP or TGA file with a palette whose entry i has the grey byte i, so that its
/// pixels decode to the numbers of their entries; nothing without a palette. All entries of a GIF
/// are opaque then. Looks at nothing beyond the end of the file, whatever its header says.
std::optional<std::string> with_palette_of_numbers(std::string_view bytes);

/// The same GIF with all its entries opaque, which keeps the colour of a clear one.
std::string with_opaque_entries(std::string gif);

}  // namespace dioptre
