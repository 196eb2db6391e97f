// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "dioptre/core/interval.h"
#include "dioptre/raster/faces.h"
#include "dioptre/raster/projected_face.h"

namespace dioptre {

/// The nearest face of one item in a pixel.
struct Fragment {
  static constexpr std::uint32_t kNoItem = std::numeric_limits<std::uint32_t>::max();
  double least = kInfinity;  ///< the least depth that the true surface can have
  double depth = kInfinity;  ///< of the face
  std::uint32_t item = kNoItem;
  bool exact = false;  ///< the face is the surface itself
};

/// The depth buffer of a square of pixels (Catmull 1974, "A subdivision algorithm for computer
/// display of curved surfaces"). A face that stands for a curved surface tells its depth only
/// about, so a pixel keeps the nearest few items rather than one: which of them is in front is
/// decided when the pixel is resolved.
class DepthTile {
 public:
  static constexpr std::int64_t kSide = 32;
  static constexpr std::size_t kKept = 16;
  using Pixel = std::array<Fragment, kKept>;  ///< in order of `least`

  /// Empties the tile, and lets it stand for these pixels, at most kSide in each direction.
  void begin(const PixelBox& box);

  /// Draws a face.
  void draw(const ScreenView& view, const FaceSet& set, const Face& face);

  const Pixel& pixel(std::int64_t column, std::int64_t row) const {
    return pixels_[index_of(column, row)];
  }

 private:
  std::size_t index_of(std::int64_t column, std::int64_t row) const {
    return static_cast<std::size_t>((row - box_.first_row) * kSide + column - box_.first_column);
  }

  PixelBox box_;
  std::vector<Pixel> pixels_;
};

}  // namespace dioptre
