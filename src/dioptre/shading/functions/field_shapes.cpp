// SPDX-License-Identifier: Apache-2.0
// Distance-like functions, coordinates, blobs and sums of noise.
#include <algorithm>
#include <cmath>

#include "dioptre/shading/functions/internal_function_families.h"
#include "dioptre/shading/noise/noise.h"

namespace dioptre::internal_functions {
namespace {

constexpr int kMaxOctaves = 64;
constexpr int kMaxPower = 64;

double square(double v) { return v * v; }

double axis_distance(const double* a) { return std::sqrt(square(a[0]) + square(a[2])); }

double blob_component(const double* a, double centre, double strength, double inverse_radius) {
  const double d2 = square(a[0] - centre) + square(a[1]) + square(a[2]);
  const double rest = 1 - square(inverse_radius) * d2;
  return rest > 0 ? strength * square(rest) : 0;
}

NoiseGenerator generator_of(double number) {
  if (number >= 3 && number < 4) return NoiseGenerator::kPerlin;
  if (number >= 2 && number < 3) return NoiseGenerator::kRangeCorrected;
  return NoiseGenerator::kOriginal;
}

/// Noise in -1 to 1 at `frequency` times the point.
double signed_noise(const double* a, double frequency, NoiseGenerator generator) {
  return 2 * noise({a[0] * frequency, a[1] * frequency, a[2] * frequency}, generator) - 1;
}

int octave_count(double octaves) {
  return octaves > 1 ? static_cast<int>(std::min<double>(octaves, kMaxOctaves)) : 1;
}

/// x^2 + e (y^2 + z^2) along each axis.
struct Ellipsoids {
  double x, y, z;
};
Ellipsoids ellipsoids(const double* a) {
  const double x2 = square(a[0]), y2 = square(a[1]), z2 = square(a[2]);
  return {x2 + a[3] * (y2 + z2), y2 + a[3] * (x2 + z2), z2 + a[3] * (x2 + y2)};
}

}  // namespace

double blob(const double* a) {
  return -(blob_component(a, -a[3] / 2, a[4], a[5]) + blob_component(a, a[3] / 2, a[6], a[7]));
}

double blob2(const double* a) {
  const double rest = square(a[1]) + square(a[2]);
  return a[6] - a[5] * (std::exp(-a[4] * (square(a[0]) + rest)) +
                        std::exp(-a[4] * (square(a[0] - a[3]) + rest)));
}

double cross_ellipsoids(const double* a) {
  const Ellipsoids e = ellipsoids(a);
  return a[6] - a[5] * std::exp(-a[4] * std::min({e.x, e.y, e.z}));
}

double isect_ellipsoids(const double* a) {
  const Ellipsoids e = ellipsoids(a);
  return a[6] - a[5] * std::exp(-a[4] * std::max({e.x, e.y, e.z}));
}

double ellipsoid(const double* a) {
  return std::sqrt(square(a[0] * a[3]) + square(a[1] * a[4]) + square(a[2] * a[5]));
}

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

double polar_angle(const double* a) { return std::atan2(axis_distance(a), a[1]); }

double azimuth(const double* a) { return std::atan2(a[0], a[2]); }

double radius(const double* a) { return std::sqrt(square(a[0]) + square(a[1]) + square(a[2])); }

double poly4(const double* a) {
  const double y = a[1];
  return axis_distance(a) - (a[3] + y * (a[4] + y * (a[5] + y * (a[6] + y * a[7]))));
}

double rounded_box(const double* a) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    sum += square(std::max(std::abs(a[i]) - (a[4 + i] - a[3]), 0.0));
  }
  constexpr double kMargin = 1e-6;
  return std::sqrt(sum) - a[3] - kMargin;
}

double sphere(const double* a) { return radius(a) - a[3]; }

double spikes_2d(const double* a) {
  return a[1] - a[3] * std::cos(a[4] * a[0]) * std::cos(a[5] * a[2]) *
                    std::exp(-a[6] * (square(a[0]) + square(a[2])));
}

double superellipsoid(const double* a) {
  const double east = 2 / a[3], north = 2 / a[4];
  const double equator = std::pow(std::abs(a[0]), east) + std::pow(std::abs(a[1]), east);
  const double sum = std::pow(equator, a[3] / a[4]) + std::pow(std::abs(a[2]), north);
  return 1 - std::pow(sum, a[4] / 2);
}

double torus(const double* a) {
  return std::sqrt(square(axis_distance(a) - a[3]) + square(a[1])) - a[4];
}

double noise_3d(const double* a) {
  return noise({a[0], a[1], a[2]}, NoiseGenerator::kRangeCorrected);
}

double noise_of_generator(const double* a) { return noise({a[0], a[1], a[2]}, generator_of(a[3])); }

}  // namespace dioptre::internal_functions
