// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "dioptre/core/vec.h"
#include "dioptre/film/antialias.h"
#include "dioptre/film/layers.h"

namespace dioptre {

/// Red, green and blue of each of Whitted's terms, in the order of LayerKind.
using TermLight = std::array<Vec3, kTerms>;

/// A sample of the image with the terms of its colour, averaged together.
struct TermSample : FilmSample {
  TermLight terms{};
};

inline TermSample operator+(const TermSample& a, const TermSample& b) {
  TermSample sum{static_cast<const FilmSample&>(a) + static_cast<const FilmSample&>(b), a.terms};
  for (std::size_t i = 0; i < kTerms; ++i) sum.terms[i] += b.terms[i];
  return sum;
}

inline TermSample operator*(const TermSample& a, float s) {
  TermSample scaled{static_cast<const FilmSample&>(a) * s, a.terms};
  for (Vec3& term : scaled.terms) term *= s;
  return scaled;
}

}  // namespace dioptre
