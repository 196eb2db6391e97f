// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/patterns/pattern_evaluator.h"

#include <cmath>
#include <numbers>

namespace dioptre {
namespace {

/// The turbulence that stands first in the list, if the pattern uses it itself.
const Turbulence* own_turbulence(const Pattern& pattern) {
  if (!has_own_turbulence(pattern.data) || pattern.warps.empty()) return nullptr;
  return std::get_if<Turbulence>(&pattern.warps.front());
}

OwnTurbulence octaves_of(const Turbulence* t) {
  if (!t) return {};
  return {t->amount, {t->octaves, t->omega, t->lambda}};
}

Wave usual_wave(const PatternData& data) {
  const bool triangle = std::holds_alternative<Marble>(data) ||
                        std::holds_alternative<Wood>(data) || std::holds_alternative<Spiral>(data);
  return triangle ? Wave::kTriangle : Wave::kRamp;
}

double shaped(double v, Wave wave, double exponent) {
  switch (wave) {
    case Wave::kRamp:
      return v;
    case Wave::kTriangle:
      return v < 0.5 ? 2 * v : 2 - 2 * v;
    case Wave::kSine:
      return (1 + std::sin(2 * std::numbers::pi * v)) / 2;
    case Wave::kScallop:
      return std::fabs(std::sin(std::numbers::pi * v));
    case Wave::kCubic:
      return v * v * (3 - 2 * v);
    case Wave::kPoly:
      return std::pow(v, exponent);
  }
  return v;
}

}  // namespace

NoiseGenerator noise_generator_of(const Pattern& pattern, const Settings& settings) {
  const std::uint32_t number =
      pattern.noise_generator ? pattern.noise_generator : settings.noise_generator;
  return number == 1   ? NoiseGenerator::kOriginal
         : number == 3 ? NoiseGenerator::kPerlin
                       : NoiseGenerator::kRangeCorrected;
}

PatternEvaluator::PatternEvaluator(const Pattern& pattern, const PatternServices& services)
    : warps_(pattern.warps, own_turbulence(pattern) != nullptr),
      field_(make_field(pattern.data, noise_generator_of(pattern, services.scene->settings),
                        octaves_of(own_turbulence(pattern)), services)),
      block_(is_block_pattern(pattern.data)),
      wave_(pattern.own_wave ? pattern.wave : usual_wave(pattern.data)),
      exponent_(pattern.wave_exponent),
      frequency_(pattern.frequency),
      phase_(pattern.phase) {}

double PatternEvaluator::value_inside(Vec3 p, const Viewpoint& viewpoint) const {
  const double raw = field_->value(p, viewpoint);
  if (block_) return raw;
  // The period is a little over 1, so that a value of exactly 1 stays 1 (measured).
  double v = raw;
  if (frequency_ != 0) {
    v = std::fmod(raw * frequency_ + phase_, 1.00001);
    if (v < 0) v -= std::floor(v);
  }
  return shaped(v, wave_, exponent_);
}

}  // namespace dioptre
