// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/patterns/pattern_evaluator.h"

#include <cmath>
#include <numbers>

namespace dioptre {
namespace {

/// Frequency and phase are kept in single precision, as the scene language keeps them.
FieldOptions options_of(const Pattern& pattern, const Settings& settings) {
  FieldOptions options;
  options.generator = noise_generator_of(pattern, settings);
  options.frequency = static_cast<float>(pattern.frequency);
  options.phase = static_cast<float>(pattern.phase);
  const auto* keyword =
      pattern.warps.empty() ? nullptr : std::get_if<Turbulence>(&pattern.warps.front());
  if (keyword) {
    options.turbulence = keyword->amount;
    options.octaves = {keyword->octaves, keyword->omega, keyword->lambda};
  }
  return options;
}

/// True if the first warp is a turbulence that the pattern uses itself.
bool skips_first_warp(const Pattern& pattern) {
  return keeps_point(pattern.data) && !pattern.warps.empty() &&
         std::holds_alternative<Turbulence>(pattern.warps.front());
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
    : warps_(pattern.warps, skips_first_warp(pattern)),
      field_(make_field(pattern.data, options_of(pattern, services.scene->settings), services)),
      block_(is_block_pattern(pattern.data)),
      wave_(pattern.own_wave ? pattern.wave : usual_wave(pattern.data)),
      exponent_(static_cast<float>(pattern.wave_exponent)),
      frequency_(static_cast<float>(pattern.frequency)),
      phase_(static_cast<float>(pattern.phase)) {}

double PatternEvaluator::value_inside(Vec3 p, const Viewpoint& viewpoint) const {
  const double raw = field_->value(p, viewpoint);
  if (block_) return raw;
  // The period is a little over 1, so that a value of exactly 1 stays 1 (measured).
  double v = raw;
  if (frequency_ != 0) v = std::fmod(raw * frequency_ + phase_, 1.00001);
  if (v < 0) v -= std::floor(v);
  return shaped(v, wave_, exponent_);
}

}  // namespace dioptre
