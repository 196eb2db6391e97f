// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace dioptre {

/// Finds stretches of [0, 1] with one sign change each of the polynomial whose coefficients in the
/// Bernstein basis are b[0] to b[degree], in order. There the polynomial has at most as many roots
/// as its coefficients change sign, and halving it brings that number down (J. Lane and
/// R. Riesenfeld, "Bounds on a polynomial", BIT 21, 1981). Stretches as short as rounding are not
/// halved further: they count if their ends differ in sign. Zero counts as positive, so that the
/// signs of both ends alone say whether the number of sign changes is odd.
///
/// Stretches for which skip(low, high) is true are left out. `found(low, high, at_low, at_high)`
/// gets a stretch and the polynomial's values at its ends; false ends the search.
template <std::size_t kSize, class Skip, class Found>
void isolate_sign_changes(const std::array<double, kSize>& b, std::size_t degree, Skip&& skip,
                          Found&& found) {
  constexpr int kDeepest = 50;
  struct Piece {
    double low, high;
    int depth;
    std::array<double, kSize> b;
  };
  std::array<Piece, kDeepest + 1> pieces;
  pieces[0].low = 0, pieces[0].high = 1, pieces[0].depth = 0;
  std::copy_n(b.begin(), degree + 1, pieces[0].b.begin());
  for (std::size_t count = 1; count > 0;) {
    Piece& piece = pieces[count - 1];
    if (skip(piece.low, piece.high)) {
      --count;
      continue;
    }
    std::size_t changes = 0;
    for (std::size_t i = 0; i < degree; ++i) changes += (piece.b[i] < 0) != (piece.b[i + 1] < 0);
    if (changes > 1 && piece.depth < kDeepest) {
      // De Casteljau's algorithm: what goes first in each round is the lower half, what is left the
      // upper one.
      Piece& lower = pieces[count++];
      lower.low = piece.low;
      lower.high = piece.low = 0.5 * (piece.low + piece.high);
      lower.depth = ++piece.depth;
      for (std::size_t k = 0; k < degree; ++k) {
        lower.b[k] = piece.b[0];
        for (std::size_t i = 0; i < degree - k; ++i) {
          piece.b[i] = 0.5 * (piece.b[i] + piece.b[i + 1]);
        }
      }
      lower.b[degree] = piece.b[0];
      continue;
    }
    --count;
    const double at_low = piece.b[0], at_high = piece.b[degree];
    if ((at_low < 0) != (at_high < 0) && !found(piece.low, piece.high, at_low, at_high)) return;
  }
}

}  // namespace dioptre
