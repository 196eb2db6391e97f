// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/patterns/crackle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dioptre {
namespace {

constexpr int kReach = 2;
constexpr std::size_t kNeighbours = 125;

/// The points of the 125 cubes around one cube. Rays ask for the same cubes again and again.
struct Neighbourhood {
  std::int64_t x = INT64_MIN, y = 0, z = 0;
  std::array<Vec3, kNeighbours> points;

  void move_to(std::int64_t cx, std::int64_t cy, std::int64_t cz) {
    if (x == cx && y == cy && z == cz) return;
    x = cx, y = cy, z = cz;
    std::size_t n = 0;
    for (int i = -kReach; i <= kReach; ++i) {
      for (int j = -kReach; j <= kReach; ++j) {
        for (int k = -kReach; k <= kReach; ++k) {
          const std::uint32_t hash = cell_hash(cx + i, cy + j, cz + k);
          points[n++] = {static_cast<double>(cx + i) + random_value(hash),
                         static_cast<double>(cy + j) + random_value(hash + 1),
                         static_cast<double>(cz + k) + random_value(hash + 2)};
        }
      }
    }
  }
};

/// A thread's last neighbourhoods, found by a hash of the cube. What is stored depends on the cube
/// alone, so sharing or losing an entry changes nothing.
const Neighbourhood& neighbourhood(std::int64_t x, std::int64_t y, std::int64_t z) {
  constexpr std::size_t kKept = 64;
  thread_local std::array<Neighbourhood, kKept> kept;
  const auto slot = static_cast<std::size_t>(x * 73856093 ^ y * 19349663 ^ z * 83492791) % kKept;
  kept[slot].move_to(x, y, z);
  return kept[slot];
}

/// A measure that orders distances like the metric, cheaper than the distance itself.
double raw_distance(Vec3 d, double metric) {
  if (metric == 2) return dot(d, d);
  const Vec3 a = abs(d);
  if (metric == 1) return a.x + a.y + a.z;
  return std::pow(a.x, metric) + std::pow(a.y, metric) + std::pow(a.z, metric);
}
double true_distance(double raw, double metric) {
  if (metric == 2) return std::sqrt(raw);
  return metric == 1 ? raw : std::pow(raw, 1 / metric);
}

}  // namespace

double crackle_value(Vec3 p, const Crackle& crackle, NoiseGenerator generator) {
  if (!(max_component(abs(p)) < 0x1p40)) p = {};
  const auto cell = [](double v) { return static_cast<std::int64_t>(std::floor(v)); };
  const Neighbourhood& near = neighbourhood(cell(p.x), cell(p.y), cell(p.z));
  const double aside = raw_distance({crackle.offset, 0, 0}, crackle.metric);
  double best[3] = {1e300, 1e300, 1e300};
  Vec3 nearest;
  for (const Vec3& point : near.points) {
    const double distance = raw_distance(p - point, crackle.metric) + aside;
    if (distance >= best[2]) continue;
    if (distance < best[0]) {
      best[2] = best[1], best[1] = best[0], best[0] = distance;
      nearest = point;
    } else if (distance < best[1]) {
      best[2] = best[1], best[1] = distance;
    } else {
      best[2] = distance;
    }
  }
  if (crackle.solid) return noise(nearest, generator);
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (crackle.form[k] != 0) sum += crackle.form[k] * true_distance(best[k], crackle.metric);
  }
  return std::clamp(sum, 0.0, 1.0);
}

}  // namespace dioptre
