// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/noise/noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <utility>

#include "dioptre/shading/noise/lattice_values.h"

namespace dioptre {
namespace {

constexpr std::uint32_t kHashSize = 4096;
constexpr std::uint32_t kGradients = 2048;
constexpr std::int64_t kLatticeShift = 10000;
constexpr double kGradientShift = 10000000.023157213;

/// The generator behind the tables and behind rand(): s -> 1812433253 s + 12345 (mod 2^32).
class LinearCongruence {
 public:
  explicit LinearCongruence(std::uint32_t seed) : state_(seed) {}
  std::uint32_t bits15() {
    state_ = state_ * 1812433253u + 12345u;
    return (state_ >> 16) & 0x7FFF;
  }
  std::uint32_t bits16() {
    state_ = state_ * 1812433253u + 12345u;
    return state_ >> 16;
  }

 private:
  std::uint32_t state_;
};

struct Tables {
  std::array<std::uint16_t, kHashSize> hash;
  std::array<Vec3, kGradients> gradients;
  std::array<std::uint16_t, kGradients> permutation;
  std::array<double, 4100> random;

  Tables() {
    for (std::uint32_t i = 0; i < kHashSize; ++i) hash[i] = static_cast<std::uint16_t>(i);
    LinearCongruence draw(0);
    for (std::uint32_t i = kHashSize; i-- > 0;) std::swap(hash[i], hash[draw.bits16() % kHashSize]);
    make_gradients();
    std::mt19937 twister(5489);
    for (double& r : random) r = twister() / 4294967296.0;
  }

 private:
  void make_gradients() {
    LinearCongruence draw(1);
    const auto component = [&] {
      return (static_cast<double>(draw.bits15() % (2 * kGradients)) - kGradients) / kGradients;
    };
    for (Vec3& gradient : gradients) {
      double size = 0;
      do {
        gradient.x = component();
        gradient.y = component();
        gradient.z = component();
        size = length(gradient);
      } while (!(size > 0 && size <= 1));
      gradient = {gradient.x / size, gradient.y / size, gradient.z / size};
    }
    std::array<std::uint16_t, kGradients + 1> shuffled{};
    for (std::uint32_t i = 0; i < kGradients; ++i) shuffled[i] = static_cast<std::uint16_t>(i);
    for (std::uint32_t i = kGradients; i > 0; i -= 2) {
      std::swap(shuffled[i], shuffled[draw.bits15() % kGradients]);
    }
    std::copy_n(shuffled.begin(), kGradients, permutation.begin());
  }
};

const Tables kTables;

constexpr double fade(double t) { return t * t * (3 - 2 * t); }
constexpr double fade_slope(double t) { return 6 * t * (1 - t); }

bool in_reach(Vec3 p) {
  const Vec3 a = abs(p);
  return a.x < 0x1p40 && a.y < 0x1p40 && a.z < 0x1p40;
}

}  // namespace

std::uint32_t cell_hash(std::int64_t x, std::int64_t y, std::int64_t z) {
  const auto& h = kTables.hash;
  const auto wrap = [](std::int64_t i) { return static_cast<std::uint32_t>(i) & 4095u; };
  return h[h[h[wrap(x)] ^ wrap(y)] ^ wrap(z)];
}

namespace {

/// Four numbers that are worked on at once: the terms of a lattice point's linear function.
using Terms = double __attribute__((vector_size(32)));

/// Compiled for AVX2 too and chosen at run time; both give the same bits.
#if defined(__x86_64__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define DIOPTRE_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define DIOPTRE_WIDE
#endif

/// The first so many components of the lattice noise at a point: between the eight corners of the
/// cell, the values of the linear functions 0.5 r0 + r1 dx + r2 dy + r3 dz, d the offset from the
/// corner. The four terms stay apart to the end.
template <std::uint32_t components>
[[gnu::always_inline]] inline void lattice_noise(Vec3 p, double* out) {
  if (!in_reach(p)) p = {};
  const double fx = std::floor(p.x), fy = std::floor(p.y), fz = std::floor(p.z);
  const Vec3 offset{p.x - fx, p.y - fy, p.z - fz};
  const auto cell = [](double floor) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(floor) + kLatticeShift);
  };
  const std::uint32_t ix = cell(fx), iy = cell(fy), iz = cell(fz);
  const double* corners[8];
  Terms offsets[8];
  const auto& h = kTables.hash;
  const Terms first{0.5, offset.x, offset.y, offset.z};
  for (std::uint32_t x = 0; x < 2; ++x) {
    const std::uint32_t hx = h[(ix + x) & 4095];
    for (std::uint32_t y = 0; y < 2; ++y) {
      const std::uint32_t hxy = h[hx ^ ((iy + y) & 4095)];
      for (std::uint32_t z = 0; z < 2; ++z) {
        const std::uint32_t corner = 4 * x + 2 * y + z;
        corners[corner] = &kLatticeValues[h[hxy ^ ((iz + z) & 4095)] & 255u];
        offsets[corner] = first - Terms{0, 1.0 * x, 1.0 * y, 1.0 * z};
      }
    }
  }
  // From each pair of neighbours to what lies between them, along z, then y, then x.
  const double shares[3] = {fade(offset.z), fade(offset.y), fade(offset.x)};
  for (std::uint32_t k = 0; k < components; ++k) {
    Terms values[8];
#pragma GCC unroll 8
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
      std::memcpy(&values[corner], corners[corner] + 4 * k, sizeof(Terms));
      values[corner] *= offsets[corner];
    }
#pragma GCC unroll 3
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
#pragma GCC unroll 4
      for (std::uint32_t i = 0; i < 4u >> axis; ++i) {
        values[i] = values[2 * i] + shares[axis] * (values[2 * i + 1] - values[2 * i]);
      }
    }
    const Terms sum = values[0];
    out[k] = (sum[0] + sum[1]) + (sum[2] + sum[3]);
  }
}

double gradient_noise(Vec3 p, Vec3* gradient = nullptr) {
  if (!in_reach(p)) p = {};
  p += {kGradientShift, kGradientShift, kGradientShift};
  const double fx = std::floor(p.x), fy = std::floor(p.y), fz = std::floor(p.z);
  const auto index = [](double f) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(f));
  };
  const std::uint32_t ix = index(fx), iy = index(fy), iz = index(fz);
  const Vec3 d{p.x - fx, p.y - fy, p.z - fz};
  const double sx = fade(d.x), sy = fade(d.y), sz = fade(d.z);
  constexpr std::uint32_t kMask = kGradients - 1;
  const auto& perm = kTables.permutation;
  double sum = 0;
  Vec3 change;
  for (std::uint32_t c = 0; c < 8; ++c) {
    const std::uint32_t x = c & 1, y = c >> 1 & 1, z = c >> 2;
    const std::uint32_t hashed = perm[(perm[(ix + x) & kMask] + iy + y) & kMask] + iz + z;
    const double w = (x ? sx : 1 - sx) * (y ? sy : 1 - sy) * (z ? sz : 1 - sz);
    const Vec3 from_corner{d.x - x, d.y - y, d.z - z};
    const Vec3& slope = kTables.gradients[hashed & kMask];
    const double ramp = dot(slope, from_corner);
    sum += w * ramp;
    if (gradient == nullptr) continue;
    const double wx = x ? sx : 1 - sx, wy = y ? sy : 1 - sy, wz = z ? sz : 1 - sz;
    change += w * slope + ramp * Vec3{(x ? 1 : -1) * fade_slope(d.x) * wy * wz,
                                      (y ? 1 : -1) * fade_slope(d.y) * wx * wz,
                                      (z ? 1 : -1) * fade_slope(d.z) * wx * wy};
  }
  if (gradient != nullptr) *gradient = 0.795 * change;
  return 0.4925 + 0.795 * sum;
}

constexpr double sum_of(Terms t) { return (t[0] + t[1]) + (t[2] + t[3]); }

/// The first component of the lattice noise and its gradient.
[[gnu::always_inline]] inline double lattice_noise_and_gradient(Vec3 p, Vec3& gradient) {
  if (!in_reach(p)) p = {};
  const double fx = std::floor(p.x), fy = std::floor(p.y), fz = std::floor(p.z);
  const Vec3 offset{p.x - fx, p.y - fy, p.z - fz};
  const auto cell = [](double floor) { return static_cast<std::int64_t>(floor) + kLatticeShift; };
  const Terms first{0.5, offset.x, offset.y, offset.z};
  Terms values[8], slopes[8];  // a value is the sum of four terms; lane 0 of a slope means nothing
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    const std::uint32_t x = corner >> 2, y = corner >> 1 & 1, z = corner & 1;
    const std::uint32_t hashed = cell_hash(cell(fx) + x, cell(fy) + y, cell(fz) + z);
    std::memcpy(&slopes[corner], &kLatticeValues[hashed & 255u], sizeof(Terms));
    values[corner] = slopes[corner] * (first - Terms{0, 1.0 * x, 1.0 * y, 1.0 * z});
  }
  const double at[3] = {offset.z, offset.y, offset.x};
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const double share = fade(at[axis]), share_slope = fade_slope(at[axis]);
    for (std::uint32_t i = 0; i < 4u >> axis; ++i) {
      const Terms step = values[2 * i + 1] - values[2 * i];
      slopes[i] = slopes[2 * i] + share * (slopes[2 * i + 1] - slopes[2 * i]);
      slopes[i][3 - axis] += share_slope * sum_of(step);
      values[i] = values[2 * i] + share * step;
    }
  }
  gradient = {slopes[0][1], slopes[0][2], slopes[0][3]};
  return sum_of(values[0]);
}

}  // namespace

DIOPTRE_WIDE double noise(Vec3 p, NoiseGenerator generator) {
  if (generator == NoiseGenerator::kPerlin) return gradient_noise(p);
  double raw = 0;
  lattice_noise<1>(p, &raw);
  const double n =
      generator == NoiseGenerator::kOriginal ? raw + 0.5 : 0.48985582 * (raw + 1.05242);
  return std::clamp(n, 0.0, 1.0);
}

DIOPTRE_WIDE double unclipped_noise(Vec3 p, NoiseGenerator generator, Vec3& gradient) {
  if (generator == NoiseGenerator::kPerlin) return gradient_noise(p, &gradient);
  const double raw = lattice_noise_and_gradient(p, gradient);
  if (generator == NoiseGenerator::kOriginal) return raw + 0.5;
  gradient = 0.48985582 * gradient;
  return 0.48985582 * (raw + 1.05242);
}

DIOPTRE_WIDE Vec3 vector_noise(Vec3 p) {
  double v[3];
  lattice_noise<3>(p, v);
  return {v[0], v[1], v[2]};
}

DIOPTRE_WIDE Vec3 vector_turbulence(Vec3 p, const Octaves& octaves) {
  Vec3 sum;
  double weight = 1, scale = 1;
  for (std::uint32_t i = 0; i < std::min(octaves.count, 10u); ++i) {
    double v[3];
    lattice_noise<3>(scale * p, v);
    sum += weight * Vec3{v[0], v[1], v[2]};
    weight *= octaves.omega;
    scale *= octaves.lambda;
  }
  return sum;
}

double spread_noise(Vec3 p, NoiseGenerator generator) {
  const double n = noise(p, generator);
  return generator == NoiseGenerator::kOriginal ? n : 2 * n - 0.5;
}

double scalar_turbulence(Vec3 p, const Octaves& octaves, NoiseGenerator generator) {
  double sum = std::clamp(spread_noise(p, generator), 0.0, 1.0);
  double weight = octaves.omega, scale = octaves.lambda;
  for (std::uint32_t i = 1; i < std::min(octaves.count, 10u); ++i) {
    sum += weight * spread_noise(scale * p, generator);
    weight *= octaves.omega;
    scale *= octaves.lambda;
  }
  return sum;
}

double random_value(std::uint32_t index) { return kTables.random[index]; }

const WaveSource& wave_source(std::uint32_t index) {
  static const auto sources = [] {
    std::array<WaveSource, kMaxWaveSources> all;
    LinearCongruence draw(3734115329u);
    for (std::uint32_t i = 0; i < kMaxWaveSources; ++i) {
      all[i].position = normalize(vector_noise({static_cast<double>(i), 0, 0}));
      all[i].frequency = 0.01 + draw.bits15() / 32767.0;
    }
    return all;
  }();
  return sources[std::min(index, kMaxWaveSources - 1)];
}

}  // namespace dioptre
