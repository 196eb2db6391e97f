// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "dioptre/core/color.h"
#include "dioptre/core/vec.h"
#include "dioptre/scene/image_source.h"

namespace dioptre {

/// An image laid on space: its unit square of x, y, or wrapped around the y axis.
class ImageSampler {
 public:
  explicit ImageSampler(const ImageSource& source);

  /// The colour at a point, with its transparency; nothing where the image does not reach.
  std::optional<PigmentColor> color(Vec3 p) const;

  /// The grey value, or what the alpha channel lets through if the image asks for it (measured); 0
  /// where it does not reach.
  double height(Vec3 p) const;

  /// How far a normal leans on the image's bumps, along u and v: differences of the heights at the
  /// point and one pixel below it to the left and right. Nothing where the image does not reach.
  std::optional<Vec2> lean(Vec3 p) const;

  /// The number that the nearest pixel stands for in a material map: its first channel as a byte.
  std::uint32_t index(Vec3 p) const;

  /// True if no light gets through any pixel.
  bool opaque() const { return opaque_; }

 private:
  struct Texel {
    float channel[5] = {0, 0, 0, 1, 0};  ///< red, green, blue, alpha, filter
  };
  std::optional<Vec2> place(Vec3 p) const;
  Texel texel(std::int64_t column, std::int64_t row) const;
  Texel sample(Vec2 uv) const;
  double height_of(const Texel& t) const;
  template <class Weight>
  Texel weighted(std::int64_t column, std::int64_t row, int from, int to, Weight weight) const;

  ImageSource source_;
  bool opaque_ = false;
};

}  // namespace dioptre
