// SPDX-License-Identifier: Apache-2.0
#include "dioptre/compare/replay.h"

#include <bit>
#include <chrono>
#include <vector>

#include "dioptre/core/rng.h"

namespace dioptre {
namespace {

void take_in(std::uint64_t& digest, std::uint64_t answer) { digest = mix_bits(digest ^ answer); }

/// Asks on behalf of rays, as the integrators do.
class Asker {
 public:
  explicit Asker(const RenderScene& scene) : scene_(scene) {}

  void ask(const SampledRay& ray, Walks& walks) {
    if (ray.purpose == RayPurpose::kShadow) return ask_for_light(ray, walks);
    Hit hit;
    if (!scene_.nearest(ray.ray, ray.range, ray.purpose, hit, walks.cost)) {
      return take_in(walks.answers, 0);
    }
    note(hit, walks);
  }

 private:
  void ask_for_light(const SampledRay& ray, Walks& walks) {
    const Item* blocker = nullptr;
    if (!scene_.shadow_hits(ray.ray, ray.range, hits_, blocker, walks.cost)) {
      return take_in(walks.answers, 0);  // which item blocks depends on the order of visits
    }
    for (const Hit& hit : hits_) note(hit, walks);
    take_in(walks.answers, 1);
  }

  void note(const Hit& hit, Walks& walks) const {
    take_in(walks.answers, std::bit_cast<std::uint64_t>(hit.crossing.t));
    take_in(walks.answers, static_cast<std::uint64_t>(hit.item - scene_.items().data()));
  }

  const RenderScene& scene_;
  std::vector<Hit> hits_;
};

}  // namespace

Walks walk_all(const RenderScene& scene, std::span<const SampledRay> rays) {
  Walks walks;
  Asker asker(scene);
  for (const SampledRay& ray : rays) asker.ask(ray, walks);
  return walks;
}

double time_walks(const RenderScene& scene, std::span<const SampledRay> rays,
                  double least_seconds) {
  if (rays.empty()) return 0;
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  double walked = 0, seconds = 0;
  do {
    walk_all(scene, rays);
    walked += static_cast<double>(rays.size());
    seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  } while (seconds < least_seconds);
  return seconds / walked * 1e9;
}

}  // namespace dioptre
