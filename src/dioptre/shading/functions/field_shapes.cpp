// SPDX-License-Identifier: Apache-2.0
// Distance-like functions, coordinates and blobs.
#include <algorithm>
#include <cmath>

#include "dioptre/shading/functions/internal_function_families.h"

namespace dioptre::internal_functions {
namespace {

double square(double v) { return v * v; }

double distance(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

double axis_distance(const double* a) { return std::sqrt(square(a[0]) + square(a[2])); }

double blob_component(const double* a, double centre, double strength, double inverse_radius) {
  const double d2 = square(a[0] - centre) + square(a[1]) + square(a[2]);
  const double rest = 1 - square(inverse_radius) * d2;
  return rest > 0 ? strength * square(rest) : 0;
}

/// x^2 + e (y^2 + z^2) along each axis.
struct Ellipsoids {
  double x, y, z;
};
Ellipsoids ellipsoids(const double* a) {
  const double x2 = square(a[0]), y2 = square(a[1]), z2 = square(a[2]);
  return {x2 + a[3] * (y2 + z2), y2 + a[3] * (x2 + z2), z2 + a[3] * (x2 + y2)};
}

/// The sum of exp(-rate e) over the three ellipsoids e.
double ellipsoid_sum(const double* a, double rate) {
  const Ellipsoids e = ellipsoids(a);
  return std::exp(-rate * e.x) + std::exp(-rate * e.y) + std::exp(-rate * e.z);
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

double flange_cover(const double* a) { return a[6] - a[5] * ellipsoid_sum(a, a[4]); }

double spikes(const double* a) {
  const double r2 = square(a[0]) + square(a[1]) + square(a[2]);
  return a[5] * (ellipsoid_sum(a, a[4]) - a[7] * std::exp(-a[6] * r2));
}

double quantum(const double* a) {
  // The density of a d orbital about y; the rate is the reference's, not quite 4/3 (measured).
  constexpr double kRate = 1.33333332;
  const double q = 2 * square(a[1]) - square(a[0]) - square(a[2]);
  return 1.2 - 1.6 * std::exp(-kRate * radius(a)) * square(q);
}

double comma(const double* a) {
  // A head, and a tail from it round a circle: half of a torus that narrows to nothing.
  const double y = a[1], z = a[2], size = a[3];
  const double x = a[0] == 0 && z == 0 ? 1e-4 : a[0];  // (measured)
  const double head = distance(x - size / 2, y, z) - size / 2;
  const double ring = std::sqrt(square(x + size / 4) + square(z)) - 0.75 * size;
  const double tail =
      std::sqrt(square(ring) + square(y)) - size / 2 * std::cos(std::atan2(z, x) / 2);
  return std::min(head, std::max(tail, -z));
}

double ellipsoid(const double* a) {
  return std::sqrt(square(a[0] * a[3]) + square(a[1] * a[4]) + square(a[2] * a[5]));
}

double polar_angle(const double* a) { return std::atan2(axis_distance(a), a[1]); }

double azimuth(const double* a) { return std::atan2(a[0], a[2]); }

double radius(const double* a) { return distance(a[0], a[1], a[2]); }

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

}  // namespace dioptre::internal_functions
