// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/patterns/crackle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dioptre {
namespace {

constexpr int kReach = 2;
constexpr std::size_t kNeighbours = 125, kClose = 27;

/// A cube beside another, in cubes.
struct Step {
  int x, y, z;
};

/// The steps to all neighbours, the 27 closest first.
constexpr auto kSteps = [] {
  std::array<Step, kNeighbours> steps{};
  std::size_t close = 0, far = kClose;
  for (int i = -kReach; i <= kReach; ++i) {
    for (int j = -kReach; j <= kReach; ++j) {
      for (int k = -kReach; k <= kReach; ++k) {
        const bool is_close = i * i <= 1 && j * j <= 1 && k * k <= 1;
        steps[is_close ? close++ : far++] = {i, j, k};
      }
    }
  }
  return steps;
}();

/// The points of the 125 cubes around one cube. Rays ask for the same cubes again and again.
struct Neighbourhood {
  std::int64_t x = INT64_MIN, y = 0, z = 0;
  std::array<Vec3, kNeighbours> points;  ///< in the order of kSteps

  void move_to(std::int64_t cx, std::int64_t cy, std::int64_t cz) {
    if (x == cx && y == cy && z == cz) return;
    x = cx, y = cy, z = cz;
    for (std::size_t n = 0; n < kNeighbours; ++n) {
      const auto [i, j, k] = kSteps[n];
      const std::uint32_t hash = cell_hash(cx + i, cy + j, cz + k);
      points[n] = {static_cast<double>(cx + i) + random_value(hash),
                   static_cast<double>(cy + j) + random_value(hash + 1),
                   static_cast<double>(cz + k) + random_value(hash + 2)};
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

/// The three least distances to points, by a measure that orders them.
class NearestThree {
 public:
  NearestThree(Vec3 p, double metric, double aside) : p_(p), metric_(metric), aside_(aside) {}

  void look_at(const Vec3& point) {
    const double distance = raw_distance(p_ - point, metric_) + aside_;
    if (distance >= best[2]) return;
    if (distance < best[0]) {
      best[2] = best[1], best[1] = best[0], best[0] = distance;
      nearest = point;
    } else if (distance < best[1]) {
      best[2] = best[1], best[1] = distance;
    } else {
      best[2] = distance;
    }
  }
  /// Whether a point at least `offset` away along each axis could be among the first rank + 1.
  bool may_count(Vec3 offset, std::size_t rank) const {
    return !(metric_ > 0) || raw_distance(offset, metric_) * (1 - 1e-12) + aside_ < best[rank];
  }

  std::array<double, 3> best{1e300, 1e300, 1e300};
  Vec3 nearest;

 private:
  Vec3 p_;
  double metric_, aside_;
};

/// How far from a place in a cube, 0 to 1, the cube so many steps on begins.
double distance_to(int steps, double place) {
  return steps == 0 ? 0 : steps > 0 ? steps - place : place - steps - 1;
}

/// Which of the least distances count: up to this one.
std::size_t last_rank(const Crackle& crackle) {
  if (crackle.solid) return 0;
  return crackle.form[2] != 0 ? 2 : crackle.form[1] != 0 ? 1 : 0;
}

}  // namespace

double crackle_value(Vec3 p, const Crackle& crackle, NoiseGenerator generator) {
  if (!(max_component(abs(p)) < 0x1p40)) p = {};
  const Vec3 floor{std::floor(p.x), std::floor(p.y), std::floor(p.z)}, place = p - floor;
  const Neighbourhood& near =
      neighbourhood(static_cast<std::int64_t>(floor.x), static_cast<std::int64_t>(floor.y),
                    static_cast<std::int64_t>(floor.z));
  NearestThree found(p, crackle.metric, raw_distance({crackle.offset, 0, 0}, crackle.metric));
  for (std::size_t n = 0; n < kClose; ++n) found.look_at(near.points[n]);
  const std::size_t rank = last_rank(crackle);
  const double to_far = 1 + std::min({place.x, place.y, place.z, 1 - max_component(place)});
  if (found.may_count({to_far, 0, 0}, rank)) {
    for (std::size_t n = kClose; n < kNeighbours; ++n) {
      const auto [i, j, k] = kSteps[n];
      const Vec3 offset{distance_to(i, place.x), distance_to(j, place.y), distance_to(k, place.z)};
      if (found.may_count(offset, rank)) found.look_at(near.points[n]);
    }
  }
  if (crackle.solid) return noise(found.nearest, generator);
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (crackle.form[k] != 0) {
      sum += crackle.form[k] * true_distance(found.best[k], crackle.metric);
    }
  }
  return std::clamp(sum, 0.0, 1.0);
}

}  // namespace dioptre
