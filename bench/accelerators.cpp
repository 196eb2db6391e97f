// SPDX-License-Identifier: Apache-2.0
// Times every accelerator on 10^2 to 10^6 spheres, spread evenly, crowded ("teapot in a stadium"),
// or spread evenly with all rays from one eye: bench_accelerators [names...]. "none" stops at 10^4
// spheres.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "dioptre/accel/accelerator.h"
#include "dioptre/core/rng.h"

namespace dioptre {
namespace {

struct Sphere {
  Vec3 center;
  double radius;
};

struct Random {
  std::uint64_t state;
  double unit() { return to_unit(mix_bits(state++)); }
  Vec3 point(double size) {
    const double x = unit(), y = unit(), z = unit();
    return size * (2 * Vec3{x, y, z} - Vec3{1, 1, 1});
  }
};

/// Spheres that fill a tenth of the cube from -1 to 1.
std::vector<Sphere> even(std::size_t count) {
  Random random{count};
  std::vector<Sphere> spheres;
  const double radius = std::cbrt(0.1 * 8 / (4.18879 * static_cast<double>(count)));
  for (std::size_t i = 0; i < count; ++i) spheres.push_back({random.point(1), radius});
  return spheres;
}

/// A tenth of the spheres in the whole cube, the others in a cube a hundredth as wide.
std::vector<Sphere> crowded(std::size_t count) {
  std::vector<Sphere> spheres = even(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (i % 10 != 0)
      spheres[i] = {0.01 * spheres[i].center + Vec3{0.3, 0.1, 0.2}, 0.01 * spheres[i].radius};
  }
  return spheres;
}

/// Keeps the nearest sphere.
class Nearest final : public LeafVisitor {
 public:
  Nearest(const std::vector<Sphere>& spheres, const Ray& ray) : spheres_(spheres), ray_(ray) {}
  bool visit(std::uint32_t item, Interval& range) override {
    const Vec3 center = spheres_[item].center - ray_.origin;
    const double middle = dot(center, ray_.direction);
    const double radius = spheres_[item].radius;
    const double half = radius * radius + middle * middle - length_squared(center);
    if (half < 0) return true;
    const double t = middle - std::sqrt(half);
    if (range.surrounds(t)) range.max = t;
    nearest = range.max;
    return true;
  }
  double nearest = kInfinity;

 private:
  const std::vector<Sphere>& spheres_;
  const Ray& ray_;
};

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// With an eye, all rays start there.
void measure(std::string_view name, const char* kind, const std::vector<Sphere>& spheres,
             std::optional<Vec3> eye = {}) {
  std::vector<Bounds> boxes;
  for (const auto& [center, radius] : spheres) {
    const Vec3 half{radius, radius, radius};
    boxes.push_back({center - half, center + half});
  }
  const auto before = std::chrono::steady_clock::now();
  const auto made = make_accelerator(name, boxes, {eye});
  const double built = seconds_since(before);
  if (!made) return;
  Random random{9};
  WalkCost cost;
  double sum = 0;
  std::size_t rays = 0;
  const auto begin = std::chrono::steady_clock::now();
  double spent = 0;
  while (spent < 0.4) {
    for (int i = 0; i < 256; ++i, ++rays) {
      // Every other ray goes to a sphere, and so mostly into the crowd.
      const Vec3 around = 3 * normalize(random.point(1) + Vec3{0, 0, 1e-9});
      const Vec3 origin = eye ? *eye : around;
      const auto pick =
          static_cast<std::size_t>(random.unit() * static_cast<double>(spheres.size()));
      const Vec3 target = i % 2 ? random.point(1) : spheres[pick].center;
      const Ray ray{origin, normalize(target - origin)};
      Nearest nearest(spheres, ray);
      (*made)->visit(ray, {0, kInfinity}, nearest, cost);
      if (nearest.nearest < kInfinity) sum += nearest.nearest;
    }
    spent = seconds_since(begin);
  }
  const auto size = (*made)->statistics();
  const double n = static_cast<double>(spheres.size()), r = static_cast<double>(rays);
  std::printf("%-7s %7zu %-11s %9.0f %8.1f %8.1f %8.1f %8.3f %7.1f %6.1f %6.1f  %.6f\n", kind,
              spheres.size(), std::string(name).c_str(), r / spent, double(cost.nodes) / r,
              double(cost.boxes) / r, double(cost.items) / r, built, double(size.bytes) / n,
              double(size.nodes) / n, double(size.references) / n, sum / r);
  std::fflush(stdout);
}

}  // namespace
}  // namespace dioptre

int main(int count, char** arguments) {
  using namespace dioptre;
  std::vector<std::string_view> names(arguments + 1, arguments + count);
  if (names.empty()) names.assign(accelerator_names().begin(), accelerator_names().end());
  std::printf("%-7s %7s %-11s %9s %8s %8s %8s %8s %7s %6s %6s  %s\n", "kind", "spheres", "name",
              "rays/s", "nodes", "boxes", "items", "build s", "bytes/n", "node/n", "refs/n",
              "mean distance");
  for (std::size_t spheres = 100; spheres <= 1000000; spheres *= 10) {
    for (const std::string_view name : names) {
      if (name == "none" && spheres > 10000) continue;
      measure(name, "even", even(spheres));
      measure(name, "crowded", crowded(spheres));
      measure(name, "eye", even(spheres), Vec3{0.3, 0.2, -3});
    }
  }
}
