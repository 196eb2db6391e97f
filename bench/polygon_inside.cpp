// SPDX-License-Identifier: Apache-2.0
// Both tests of whether a point is inside a polygon, timed by turns: nanoseconds for one point.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "dioptre/core/rng.h"
#include "dioptre/geometry/outline/outline.h"
#include "dioptre/geometry/polygon/angle_sum.h"

namespace {

using namespace dioptre;

constexpr int kPoints = 20000, kRounds = 9;

double random_number(std::uint32_t i, std::uint32_t dimension) {
  return random_at(1, 2, i, dimension);
}

std::vector<Vec2> star(int corners) {
  std::vector<Vec2> ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    const double reach = 1 - 0.5 * random_number(static_cast<std::uint32_t>(i), 0);
    ring.push_back({reach * std::cos(angle), reach * std::sin(angle)});
  }
  return ring;
}

/// The shortest of the rounds, in nanoseconds for one point.
template <class Test>
double measure(const std::vector<Vec2>& points, int& inside, Test test) {
  const auto begin = std::chrono::steady_clock::now();
  for (const Vec2 p : points) inside += test(p) ? 1 : 0;
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  return time.count() / static_cast<double>(points.size()) * 1e9;
}

}  // namespace

int main() {
  std::vector<Vec2> points;
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    points.push_back({2 * random_number(i, 1) - 1, 2 * random_number(i, 2) - 1});
  }
  std::puts("corners  crossings ns  angles ns  ratio");
  for (const int corners : {3, 10, 30, 100, 300, 1000}) {
    const std::vector<std::vector<Vec2>> rings{star(corners)};
    Outline outline;
    outline.move_to(rings[0][0]);
    for (std::size_t i = 1; i < rings[0].size(); ++i) {
      outline.add(line(rings[0][i - 1], rings[0][i]));
    }
    outline.close();
    double crossings = 1e30, angles = 1e30;
    int by_crossings = 0, by_angles = 0;
    for (int round = 0; round < kRounds; ++round) {
      crossings = std::min(crossings, measure(points, by_crossings, [&](Vec2 p) {
                             return outline.contains_even_odd(p);
                           }));
      angles = std::min(
          angles, measure(points, by_angles, [&](Vec2 p) { return inside_by_angles(rings, p); }));
    }
    std::printf("%7d  %12.1f  %9.1f  %5.1f%s\n", corners, crossings, angles, angles / crossings,
                by_crossings == by_angles ? "" : "  THEY DIFFER");
  }
}
