// SPDX-License-Identifier: Apache-2.0
#include "dioptre/film/antialias.h"

namespace dioptre {

std::vector<std::uint8_t> pixels_to_refine(const Image& centres, const AntialiasSettings& settings,
                                           std::uint32_t first_column, std::uint32_t first_row,
                                           std::uint32_t end_column, std::uint32_t end_row) {
  std::vector<std::uint8_t> refine(centres.pixels.size(), 0);
  const double inverse_gamma = 1 / settings.gamma;
  const auto compare = [&](std::size_t a, std::size_t b) {
    const Color first = centres.pixels[a], second = centres.pixels[b];
    if (first == second && settings.threshold > 0) return;
    if (antialias_difference(first, second, inverse_gamma) < settings.threshold) return;
    refine[a] = refine[b] = 1;
  };
  for (std::uint32_t y = first_row; y < end_row; ++y) {
    for (std::uint32_t x = first_column; x < end_column; ++x) {
      const std::size_t at = std::size_t{y} * centres.width + x;
      if (x > first_column) compare(at - 1, at);
      if (y > first_row) compare(at - centres.width, at);
    }
  }
  return refine;
}

}  // namespace dioptre
