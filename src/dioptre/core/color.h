// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace dioptre {

/// Linear light: red, green, blue. Unbounded.
struct Color {
  float r = 0, g = 0, b = 0;

  constexpr Color& operator+=(Color c) { return r += c.r, g += c.g, b += c.b, *this; }
  constexpr Color& operator*=(Color c) { return r *= c.r, g *= c.g, b *= c.b, *this; }
  constexpr Color& operator*=(float s) { return r *= s, g *= s, b *= s, *this; }
  bool operator==(const Color&) const = default;
};

constexpr Color operator+(Color a, Color b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
constexpr Color operator-(Color a, Color b) { return {a.r - b.r, a.g - b.g, a.b - b.b}; }
constexpr Color operator*(Color a, Color b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
constexpr Color operator*(Color a, float s) { return {a.r * s, a.g * s, a.b * s}; }
constexpr Color operator*(float s, Color a) { return a * s; }
constexpr float max_component(Color c) { return std::max(c.r, std::max(c.g, c.b)); }
inline Color abs(Color c) { return {std::fabs(c.r), std::fabs(c.g), std::fabs(c.b)}; }
constexpr bool is_black(Color c) { return c.r == 0 && c.g == 0 && c.b == 0; }
/// The weights of a scene file's `.gray`.
constexpr float gray(Color c) { return 0.297f * c.r + 0.589f * c.g + 0.114f * c.b; }

/// A pigment's colour: what the surface shows, and how much light it lets through, tinted by the
/// colour (`filter`) or untinted (`transmit`).
struct PigmentColor {
  Color color;
  float filter = 0, transmit = 0;

  /// The share of the light behind the surface that comes through it.
  constexpr Color transmittance() const {
    return color * filter + Color{transmit, transmit, transmit};
  }
  /// The share of the surface's own light; not clamped.
  constexpr float opacity() const { return 1 - filter - transmit; }
  bool operator==(const PigmentColor&) const = default;
};

constexpr PigmentColor operator+(PigmentColor a, PigmentColor b) {
  return {a.color + b.color, a.filter + b.filter, a.transmit + b.transmit};
}
constexpr PigmentColor operator*(PigmentColor a, float s) {
  return {a.color * s, a.filter * s, a.transmit * s};
}

}  // namespace dioptre
