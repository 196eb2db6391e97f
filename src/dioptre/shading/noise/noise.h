// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "dioptre/core/vec.h"

namespace dioptre {

/// Which noise a pattern is made of; the scene language's numbers.
enum class NoiseGenerator : std::uint8_t { kOriginal = 1, kRangeCorrected = 2, kPerlin = 3 };

/// How turbulence adds up noise: octaves i = 0, 1, ... at lambda^i with weight omega^i.
struct Octaves {
  std::uint32_t count = 6;
  double omega = 0.5;
  double lambda = 2;
};

/// Smooth noise in [0, 1]. Generators 1 and 2 are lattice noise (cubic weights, a value and a slope
/// per lattice point) with period 4096; generator 3 is gradient noise (K. Perlin) with period 2048.
/// Points that are not finite or beyond 2^40 count as the origin.
double noise(Vec3 p, NoiseGenerator generator);

/// The same before it is clipped to [0, 1], with its gradient, which is continuous.
double unclipped_noise(Vec3 p, NoiseGenerator generator, Vec3& gradient);

/// Lattice noise with a vector value, about -1 to 1 in each component; the same for all generators.
Vec3 vector_noise(Vec3 p);

/// The sum of octaves of vector_noise.
Vec3 vector_turbulence(Vec3 p, const Octaves& octaves);

/// The scalar turbulence of marble, agate and fog.
double scalar_turbulence(Vec3 p, const Octaves& octaves, NoiseGenerator generator);

/// 2 n - 0.5 of range-corrected or gradient noise, n of the original: what granite's relatives add
/// up. Not clipped.
double spread_noise(Vec3 p, NoiseGenerator generator);

/// The hash of an integer lattice cell, 0 to 4095.
std::uint32_t cell_hash(std::int64_t x, std::int64_t y, std::int64_t z);

/// Number `index` (below 4100) of a fixed random sequence in [0, 1): mt19937 with seed 5489.
double random_value(std::uint32_t index);

/// A source of ripples and waves: a unit vector and a frequency; ten are used unless the scene says
/// another number.
struct WaveSource {
  Vec3 position;
  double frequency = 1;
};
inline constexpr std::uint32_t kMaxWaveSources = 100;
const WaveSource& wave_source(std::uint32_t index);

}  // namespace dioptre
