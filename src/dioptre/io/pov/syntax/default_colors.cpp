// SPDX-License-Identifier: Apache-2.0
// The colours of patterns that are given none, measured.
#include "dioptre/io/pov/syntax/patterns.h"

namespace dioptre::pov {
namespace {

using Entries = std::vector<ColorEntry>;

ColorEntry entry(double position, float r, float g, float b) {
  return {position, {{r, g, b}, 0, 0}};
}

struct DefaultColors {
  Entries operator()(const Agate&) const {
    return {entry(0, 1, 1, 1),
            entry(0.5, 0.95f, 0.75f, 0.5f),
            entry(0.5, 0.9f, 0.7f, 0.5f),
            entry(0.6, 0.9f, 0.7f, 0.4f),
            entry(0.6, 1, 0.7f, 0.4f),
            entry(1, 0.6f, 0.3f, 0)};
  }
  Entries operator()(const Bozo&) const {
    return {entry(0.4, 1, 1, 1), entry(0.4, 0, 1, 0), entry(0.6, 0, 1, 0),
            entry(0.6, 0, 0, 1), entry(0.8, 0, 0, 1), entry(0.8, 1, 0, 0)};
  }
  Entries operator()(const Marble&) const {
    return {entry(0, 0.9f, 0.8f, 0.8f), entry(0.9, 0.9f, 0.08f, 0.08f), entry(0.9, 0, 0, 0)};
  }
  Entries operator()(const Wood&) const {
    return {entry(0.6, 0.666f, 0.312f, 0.2f), entry(0.6, 0.4f, 0.133f, 0.066f)};
  }
  Entries operator()(const Radial&) const {
    return {entry(0, 0, 1, 1), entry(1.0 / 3, 1, 1, 0), entry(2.0 / 3, 1, 0, 1), entry(1, 0, 1, 1)};
  }
  Entries operator()(const Fractal& fractal) const {
    if (fractal.julia || fractal.magnet) return grays();
    return {entry(0.001, 0, 0, 0), entry(0.001, 0, 1, 1), entry(0.012, 1, 1, 0),
            entry(0.015, 1, 0, 1), entry(0.1, 0, 1, 1)};
  }
  Entries operator()(const Brick&) const {
    return {entry(0, 0.5f, 0.5f, 0.5f), entry(1, 0.6f, 0.15f, 0.15f)};
  }
  Entries operator()(const Checker&) const { return {entry(0, 0, 0, 1), entry(1, 0, 1, 0)}; }
  Entries operator()(const ObjectPattern&) const { return {entry(0, 0, 0, 1), entry(1, 0, 1, 0)}; }
  Entries operator()(const Hexagon&) const {
    return {entry(0, 0, 0, 1), entry(1, 0, 1, 0), entry(2, 1, 0, 0)};
  }
  Entries operator()(const Square&) const {
    return {entry(0, 1, 0, 0), entry(1, 0, 1, 0), entry(2, 0, 0, 1), entry(3, 1, 1, 0)};
  }
  Entries operator()(const Triangular&) const { return six(); }
  Entries operator()(const Cubic&) const { return six(); }
  template <class T>
  Entries operator()(const T&) const {
    return grays();
  }

 private:
  static Entries grays() { return {entry(0, 0, 0, 0), entry(1, 1, 1, 1)}; }
  static Entries six() {
    return {entry(0, 1, 0, 0), entry(1, 0, 1, 0), entry(2, 0, 0, 1),
            entry(3, 1, 1, 0), entry(4, 0, 1, 1), entry(5, 1, 0, 1)};
  }
};

}  // namespace

std::vector<ColorEntry> default_colors(const Pattern& pattern) {
  return std::visit(DefaultColors{}, pattern.data);
}

}  // namespace dioptre::pov
