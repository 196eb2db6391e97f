// SPDX-License-Identifier: Apache-2.0
#include "dioptre/film/transfer_curve.h"

#include <algorithm>
#include <cmath>

namespace dioptre {

TransferCurve::TransferCurve(std::function<double(float)> exact, double top)
    : exact_(std::move(exact)),
      top_(top),
      doubt_(top * 1e-6 + 1e-9),
      lowest_(exact_level(0)),
      highest_(exact_level(1)) {
  const auto at = [&](double piece) {
    const auto bits = static_cast<std::uint32_t>(piece * (1u << kPieceBits));
    return exact_(std::bit_cast<float>(kFirst + bits)) * top_ + 0.5;
  };
  double start = at(0);
  for (std::size_t i = 0; i < kPieces; ++i) {
    const double x = static_cast<double>(i);
    const double quarter = at(x + 0.25), middle = at(x + 0.5), end = at(x + 1);
    const double c = 2 * (start - 2 * middle + end);
    pieces_[i] = {start, end - start - c, c};
    // A kink of the curve: 0 is always in doubt.
    const double guess = start + 0.25 * pieces_[i].b + 0.0625 * c;
    if (!(std::fabs(guess - quarter) < doubt_ / 2)) pieces_[i] = {};
    start = end;
  }
}

std::uint16_t TransferCurve::exact_level(float v) const {
  return static_cast<std::uint16_t>(std::clamp(std::floor(exact_(v) * top_ + 0.5), 0.0, top_));
}

}  // namespace dioptre
