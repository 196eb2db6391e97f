// SPDX-License-Identifier: Apache-2.0
#include "dioptre/compare/ray_sample.h"

#include <algorithm>

#include "dioptre/core/parallel.h"
#include "dioptre/core/rng.h"
#include "dioptre/integrators/eye_rays.h"

namespace dioptre {
namespace {

/// Picks rays of one row of the picture as they are traced.
class Collector final : public RayObserver {
 public:
  Collector(std::uint32_t row, const std::array<double, kRaySorts>& share) : row_(row) {
    std::copy(share.begin(), share.end(), share_.begin());
  }

  void begin(const RayStart& start) override {
    switch (start.kind) {
      case RayKind::kCamera:
        return follow(RaySort::kEye, start.ray, RayPurpose::kCamera);
      case RayKind::kReflected:
        return follow(RaySort::kReflected, start.ray, RayPurpose::kReflection);
      case RayKind::kTransmitted:
        // It goes on for what it comes from.
        return follow(RaySort::kTransmitted, start.ray, open_.back());
    }
  }
  void meet(const Hit&, const SurfaceInteraction&, const TextureSample&) override {}
  void receive(LightTerm, Color) override {}
  void shadow(const ShadowRay& ray) override {
    offer(RaySort::kShadow, {ray.ray, ray.range, RayPurpose::kShadow});
  }
  void end() override { open_.pop_back(); }

  RaySample picked;

 private:
  void follow(RaySort sort, const Ray& ray, RayPurpose purpose) {
    open_.push_back(purpose);
    offer(sort, {ray, {0, kInfinity}, purpose});
  }

  void offer(RaySort sort, const SampledRay& ray) {
    const auto index = static_cast<std::size_t>(sort);
    if (random_at(row_, seen_[index]++, 0, index) < share_[index]) picked[index].push_back(ray);
  }

  std::uint32_t row_;
  std::array<double, kRaySorts> share_{};
  std::array<std::uint32_t, kRaySorts> seen_{};
  std::vector<RayPurpose> open_;
};

void trace_row(const EyeRays& eye, const RayIntegrator& integrator, const PixelRegion& region,
               std::uint32_t row, RayLog& log) {
  const auto trace = [&](double x, double y, Vec2 lens) -> FilmSample {
    return eye.mean([&](std::uint32_t number) -> std::optional<FilmSample> {
      const auto ray = eye.ray(x, y, lens, number);
      if (!ray) return std::nullopt;
      const Radiance radiance = integrator.radiance(*ray, log);
      return FilmSample{radiance.color, radiance.alpha};
    });
  };
  for (std::uint32_t column = region.first_column; column < region.end_column; ++column) {
    const double x = column + 0.5, y = row + 0.5;
    if (eye.lens()) {
      eye.lens()->mean(x, y, 1, trace);
    } else {
      trace(x, y, {0.5, 0.5});
    }
  }
}

}  // namespace

const char* name_of(RaySort sort) {
  constexpr std::array kNames{"eye", "shadow", "reflected", "transmitted"};
  return kNames[static_cast<std::size_t>(sort)];
}

std::uint64_t count_of(const RayCounts& rays, RaySort sort) {
  const std::array counts{rays.camera, rays.shadow, rays.reflected, rays.transmitted};
  return counts[static_cast<std::size_t>(sort)];
}

Result<RaySample> sample_rays(const RenderScene& scene, const RenderOptions& options,
                              const RayCounts& traced, std::size_t most) {
  const auto eye = EyeRays::prepare(scene, options.width, options.height);
  if (!eye) return tl::unexpected(eye.error());
  const auto integrator = make_integrator(options.integrator, scene, options.integrator_options);
  if (!integrator) return tl::unexpected(integrator.error());
  std::array<double, kRaySorts> share{};
  for (const RaySort sort : kAllRaySorts) {
    const auto count = static_cast<double>(std::max<std::uint64_t>(count_of(traced, sort), 1));
    share[static_cast<std::size_t>(sort)] = static_cast<double>(most) / count;
  }
  const PixelRegion region = region_within(options.region, options.width, options.height);
  std::vector<RaySample> rows(region.end_row - region.first_row);
  const auto count = static_cast<std::uint32_t>(rows.size());
  parallel_for(count, options.threads, nullptr, [&](std::uint32_t i) {
    Collector collector(region.first_row + i, share);
    RayLog log;
    log.observer = &collector;
    trace_row(*eye, **integrator, region, region.first_row + i, log);
    rows[i] = std::move(collector.picked);
  });
  RaySample all;
  for (const RaySample& row : rows) {
    for (std::size_t sort = 0; sort < kRaySorts; ++sort) {
      all[sort].insert(all[sort].end(), row[sort].begin(), row[sort].end());
    }
  }
  return all;
}

}  // namespace dioptre
