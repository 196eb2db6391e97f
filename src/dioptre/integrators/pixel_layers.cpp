// SPDX-License-Identifier: Apache-2.0
#include "dioptre/integrators/pixel_layers.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "dioptre/integrators/thread_time.h"

namespace dioptre {
namespace {

bool needs_watch(LayerSet wanted) {
  return wanted.has_any(LayerSet::terms()) || wanted.has(LayerKind::kSpans) ||
         wanted.has(LayerKind::kDepth);
}

}  // namespace

PixelLog::PixelLog(const RenderScene& scene, LayerSet wanted) : watch(scene, wanted) {
  if (needs_watch(wanted)) rays.observer = &watch;
}

PixelLayers::PixelLayers(LayerSet wanted, std::size_t pixels) : wanted_(wanted) {
  for (const LayerInfo& info : layer_infos()) {
    if (!wanted.has(info.kind)) continue;
    const float unset =
        info.kind == LayerKind::kDepth ? std::numeric_limits<float>::infinity() : 0.0f;
    values(info.kind).assign(pixels * info.channels.size(), unset);
  }
}

PixelLayers::Snapshot PixelLayers::snapshot(const PixelLog& log) const {
  const std::int64_t time =
      wanted_.has(LayerKind::kTime) ? thread_nanoseconds() - log.watch.own_time() : 0;
  return {log.rays.counts.total(), log.rays.walks, log.watch.spans(), time};
}

void PixelLayers::add_cost(std::size_t at, const Snapshot& before, PixelLog& log) {
  const Snapshot now = snapshot(log);
  add(LayerKind::kRays, at, static_cast<double>(now.rays - before.rays));
  add(LayerKind::kSteps, at, static_cast<double>(now.walks.nodes - before.walks.nodes));
  add(LayerKind::kTests, at, static_cast<double>(now.walks.items - before.walks.items));
  add(LayerKind::kSpans, at, static_cast<double>(now.spans - before.spans));
  add(LayerKind::kTime, at, static_cast<double>(now.time - before.time));
  const auto depth = static_cast<float>(log.watch.take_depth());
  if (!wanted_.has(LayerKind::kDepth)) return;
  float& nearest = values(LayerKind::kDepth)[at];
  nearest = std::min(nearest, depth);
}

void PixelLayers::add(LayerKind kind, std::size_t at, double value) {
  if (wanted_.has(kind)) values(kind)[at] += static_cast<float>(value);
}

void PixelLayers::set_terms(std::size_t at, const TermLight& terms) {
  for (std::size_t term = 0; term < kTerms; ++term) {
    if (values_[term].empty()) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      values_[term][3 * at + k] = static_cast<float>(terms[term][k]);
    }
  }
}

TermLight PixelLayers::terms(std::size_t at) const {
  TermLight terms{};
  for (std::size_t term = 0; term < kTerms; ++term) {
    if (values_[term].empty()) continue;
    for (std::size_t k = 0; k < 3; ++k) terms[term][k] = values_[term][3 * at + k];
  }
  return terms;
}

std::vector<ImageLayer> PixelLayers::take() {
  std::vector<ImageLayer> layers;
  for (const LayerInfo& info : layer_infos()) {
    if (!wanted_.has(info.kind)) continue;
    layers.push_back(
        {std::string(info.name), std::string(info.channels), std::move(values(info.kind))});
  }
  return layers;
}

}  // namespace dioptre
