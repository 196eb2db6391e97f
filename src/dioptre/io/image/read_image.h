// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dioptre/core/result.h"
#include "dioptre/scene/image_source.h"

namespace dioptre {

/// The share of light that an entry of a palette lets through.
struct EntryShare {
  std::uint8_t entry = 0;
  float share = 0;
  bool operator==(const EntryShare&) const = default;
};

/// How the values of an image file become linear light, and how large it may be.
struct ReadImageOptions {
  /// Wins over what the file and its format say: light is value^gamma. 1 reads values as they are.
  std::optional<double> gamma;
  /// The version of the scene language: under 3.7 only a gamma written in the file is applied, else
  /// values without one are decoded as their format has it (PNG and JPEG: sRGB).
  double language_version = 3.7;
  /// If not 0, an image that has a palette gives the numbers of its entries times this, one
  /// channel.
  float palette_scale = 0;
  /// How much light passes through the colours of single entries of a palette, from 0 to 1, instead
  /// of what the file says. An error if there is no palette.
  std::vector<EntryShare> entry_transmits;
  /// The same for the light that is filtered: the image gets five channels.
  std::vector<EntryShare> entry_filters;
  /// What the file says of the transparency of its palette is forgotten.
  bool opaque_palette = false;
  /// Light that was decoded is given as light^(1 / working_gamma): the scene's own values.
  double working_gamma = 1;
  /// A PNG of grey bytes has whole 255ths of light, rounded down, as POV-Ray keeps it (measured).
  bool grey_light_bytes = false;
  /// Larger images are refused before any memory is taken.
  std::uint64_t max_pixels = std::uint64_t{1} << 28;

  bool operator==(const ReadImageOptions&) const = default;
};

/// Reads PNG, JPEG, TIFF, PNM (PGM, PPM), OpenEXR, Radiance HDR, GIF, TGA and BMP, known by their
/// content (TGA: by its name). Alpha and OpenEXR and HDR values are taken as they are. The error
/// names the file, the reason and, where known, the byte offset; it never quotes the file.
Result<ImageData> read_image(const std::string& path, const ReadImageOptions& options);

}  // namespace dioptre
