// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/interval_jet.h"
#include "dioptre/shading/noise/noise.h"

namespace dioptre {

/// The steepest that the noise of a generator is anywhere: no two values differ by more than this
/// times the distance of their points.
double steepest_noise(NoiseGenerator generator);

/// Bounds of the noise where x, y and z are functions of one number.
IntervalJet noise_range(const IntervalJet& x, const IntervalJet& y, const IntervalJet& z,
                        NoiseGenerator generator);

}  // namespace dioptre
