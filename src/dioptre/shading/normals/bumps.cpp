// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/normals/bumps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dioptre/shading/patterns/quilted.h"

namespace dioptre {
namespace {

Vec3 wrinkles(Vec3 p) {
  Vec3 sum;
  double scale = 1;
  for (int i = 0; i < 10; ++i) {
    sum += abs(vector_noise(scale * p)) / scale;
    scale *= 2;
  }
  return sum;
}

/// Away from the centre of each unit cube, by the curve of the quilt.
Vec3 cushions(Vec3 p, const Quilted& quilted) {
  const auto off = [](double v) { return v - std::floor(v) - 0.5; };
  const Vec3 out{off(p.x), off(p.y), off(p.z)};
  return 2 / std::numbers::sqrt3 * quilted_curve(length(out), quilted) * out;
}

/// Circular waves around the sources, which lower frequencies are the higher for if `own`
/// frequencies count.
Vec3 circles(Vec3 p, std::uint32_t sources, double frequency, double phase, bool own) {
  constexpr double kTurn = 2 * std::numbers::pi;
  Vec3 sum;
  for (std::uint32_t i = 0; i < sources; ++i) {
    const WaveSource& source = wave_source(i);
    const Vec3 out = p - source.position;
    const double distance = length(out);
    if (!(distance > 0)) continue;
    const double f = own ? source.frequency : 1;
    const double wave = std::sin(kTurn * (distance * frequency * f + phase)) / f;
    sum += wave / distance * out;
  }
  return sum / sources;
}

}  // namespace

bool Bump::exists_for(const PatternData& data) {
  return std::holds_alternative<Bumps>(data) || std::holds_alternative<Dents>(data) ||
         std::holds_alternative<Wrinkles>(data) || std::holds_alternative<Quilted>(data) ||
         std::holds_alternative<Ripples>(data) || std::holds_alternative<Waves>(data);
}

Bump::Kind Bump::kind_of(const PatternData& data) {
  if (std::holds_alternative<Dents>(data)) return Kind::kDents;
  if (std::holds_alternative<Wrinkles>(data)) return Kind::kWrinkles;
  if (std::holds_alternative<Quilted>(data)) return Kind::kQuilted;
  if (std::holds_alternative<Ripples>(data)) return Kind::kRipples;
  return std::holds_alternative<Waves>(data) ? Kind::kWaves : Kind::kBumps;
}

Bump::Bump(const Pattern& pattern, NoiseGenerator generator, std::uint32_t wave_sources)
    : kind_(kind_of(pattern.data)),
      generator_(generator),
      sources_(std::clamp(wave_sources, 1u, kMaxWaveSources)),
      frequency_(pattern.frequency),
      phase_(pattern.phase) {
  if (const auto* quilted = std::get_if<Quilted>(&pattern.data)) quilted_ = *quilted;
}

Vec3 Bump::at(Vec3 p) const {
  switch (kind_) {
    case Kind::kBumps:
      return vector_noise(p);
    case Kind::kDents: {
      const double n = noise(p, generator_);
      return n * n * n * vector_noise(p);
    }
    case Kind::kWrinkles:
      return wrinkles(p);
    case Kind::kQuilted:
      return cushions(p, quilted_);
    case Kind::kRipples:
      return circles(p, sources_, frequency_, phase_, false);
    case Kind::kWaves:
      return circles(p, sources_, frequency_, phase_, true);
  }
  return {};
}

}  // namespace dioptre
