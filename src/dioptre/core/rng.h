// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace dioptre {

/// Scrambles 64 bits: every output bit depends on every input bit (Steele, Lea and Flood 2014,
/// "Fast splittable pseudorandom number generators", the finalizer of SplitMix64).
constexpr std::uint64_t mix_bits(std::uint64_t v) {
  v += 0x9e3779b97f4a7c15;
  v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9;
  v = (v ^ (v >> 27)) * 0x94d049bb133111eb;
  return v ^ (v >> 31);
}

/// A number in [0, 1) with 53 random bits from 64 bits.
constexpr double to_unit(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

/// Random numbers that follow from a counter alone, so that an image does not depend on the order
/// in which it is computed: the same pixel, sample and dimension give the same number.
constexpr double random_at(std::uint32_t x, std::uint32_t y, std::uint32_t sample,
                           std::uint32_t dimension) {
  const std::uint64_t pixel = (std::uint64_t{x} << 32) | y;
  const std::uint64_t draw = (std::uint64_t{sample} << 32) | dimension;
  return to_unit(mix_bits(mix_bits(pixel) ^ draw));
}

}  // namespace dioptre
