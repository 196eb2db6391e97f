// SPDX-License-Identifier: Apache-2.0
// Noise, and sums of noise over octaves.
#include <algorithm>
#include <cmath>

#include "dioptre/shading/functions/internal_function_families.h"
#include "dioptre/shading/noise/noise.h"

namespace dioptre::internal_functions {
namespace {

constexpr int kMaxOctaves = 64;
constexpr int kMaxPower = 64;

double square(double v) { return v * v; }

/// The generator by its number: the whole part modulo 4, where 0 counts as 1 (measured).
NoiseGenerator generator_of(double number) {
  const double rest = std::fmod(std::trunc(number), 4);
  if (rest == 3 || rest == -1) return NoiseGenerator::kPerlin;
  if (rest == 2 || rest == -2) return NoiseGenerator::kRangeCorrected;
  return NoiseGenerator::kOriginal;
}

/// Noise in 0 to 1 at `frequency` times the point.
double noise_at(const double* a, double frequency, NoiseGenerator generator) {
  return noise({a[0] * frequency, a[1] * frequency, a[2] * frequency}, generator);
}

/// Noise in -1 to 1 at `frequency` times the point.
double signed_noise(const double* a, double frequency, NoiseGenerator generator) {
  return 2 * noise_at(a, frequency, generator) - 1;
}

int octave_count(double octaves) {
  return octaves > 1 ? static_cast<int>(std::min<double>(octaves, kMaxOctaves)) : 1;
}

/// 0 at `origin`, and 1 or -1 at whichever of 0 and 1 is the farther from it.
double from_origin(double value, double origin) {
  return (value - origin) / (origin < 0.5 ? 1 - origin : origin);
}

}  // namespace

double hetero_mf(const double* a) {
  // F. K. Musgrave's heterogeneous multifractal; octaves are scaled by whole powers of the sum;
  // the last of a broken number of octaves counts in part.
  const NoiseGenerator generator = generator_of(a[8]);
  const double count = std::min<double>(a[5], kMaxOctaves);
  const int power = a[7] > 1 ? static_cast<int>(std::min<double>(a[7], kMaxPower)) : a[7] == 1;
  double value = signed_noise(a, 1, generator) + a[6];
  double frequency = 1;
  for (int i = 1; i < count; ++i) {
    frequency *= a[4];
    const double weight = std::pow(frequency, -a[3]) * std::pow(value, power);
    const double share = std::min(1.0, count - i);
    value += share * (signed_noise(a, frequency, generator) + a[6]) * weight;
  }
  return value;
}

double ridged_mf(const double* a) {
  // F. K. Musgrave's ridged multifractal.
  const NoiseGenerator generator = generator_of(a[8]);
  const int octaves = octave_count(a[5]);
  double signal = square(a[6] - std::abs(signed_noise(a, 1, generator)));
  double value = signal, frequency = 1;
  for (int i = 1; i < octaves; ++i) {
    frequency *= a[4];
    const double weight = std::clamp(signal * a[7], 0.0, 1.0);
    signal = weight * square(a[6] - std::abs(signed_noise(a, frequency, generator)));
    value += signal * std::pow(frequency, -a[3]);
  }
  return value;
}

double ridge(const double* a) {
  // Octaves of noise folded at the ridge, weighted by powers of omega; what is left of a broken
  // number of octaves weighs the one after the last, even when there is but one (measured).
  const NoiseGenerator generator = generator_of(a[8]);
  const int octaves = octave_count(a[4]);
  const auto folded = [&](double frequency) {
    return std::abs(from_origin(noise_at(a, frequency, generator), a[7]));
  };
  double sum = 0, weights = 0, weight = 1, frequency = 1;
  for (int i = 0; i < octaves; ++i, frequency *= a[3], weight *= a[5]) {
    sum += weight * folded(frequency);
    weights += weight;
  }
  const double rest = a[4] - std::trunc(a[4]);
  if (rest != 0) {
    sum += rest * weight * folded(frequency);
    weights += rest * weight;
  }
  return from_origin(sum / weights, a[6]);
}

double noise_3d(const double* a) {
  return noise({a[0], a[1], a[2]}, NoiseGenerator::kRangeCorrected);
}

double noise_of_generator(const double* a) { return noise({a[0], a[1], a[2]}, generator_of(a[3])); }

}  // namespace dioptre::internal_functions
