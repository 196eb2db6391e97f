// SPDX-License-Identifier: Apache-2.0
#include "dioptre/raster/scene_faces.h"

#include <algorithm>
#include <cmath>

#include "dioptre/core/parallel.h"
#include "dioptre/raster/flat_faces.h"
#include "dioptre/raster/surface_net.h"

namespace dioptre {
namespace {

/// An item that is to be cut up.
struct CurvedItem {
  std::uint32_t item;
  ViewLattice lattice;
};

ViewScale scale_of(const RenderScene& scene, const ScreenView& view) {
  constexpr double kFar = 1e4;
  const Vec3 eye = view.to_world(view.at({view.width() / 2.0, view.height() / 2.0}, 0));
  double least = kInfinity, most = 0;
  for (const Item& item : scene.items()) {
    const Bounds box = item.shape->bounds();
    if (box.empty() || !box.finite()) continue;
    const double size = max_component(box.extent()) + length(box.center() - eye);
    if (!(size > 0) || !std::isfinite(size)) continue;
    least = std::min(least, size);
    most = std::max(most, size);
  }
  if (most == 0) least = most = 1 + length(eye);
  return {least, kFar * most};
}

/// Adds faces item by item; those that are cut up are gathered until they are worth all cores.
class FaceBuilder {
 public:
  FaceBuilder(const RenderScene& scene, const ScreenView& view, std::uint32_t threads,
              const std::atomic<bool>* cancel)
      : scene_(scene), view_(view), threads_(threads), cancel_(cancel) {}

  bool add_all() {
    const ViewScale scale = scale_of(scene_, view_);
    const auto primitives = placed_primitives(scene_);
    for (std::uint32_t i = 0; i < scene_.items().size(); ++i) {
      if (scene_.items()[i].no_image) continue;
      const FlatFaces flat = primitives[i] ? add_flat_faces(view_, *primitives[i], scale, i, set_)
                                           : FlatFaces::kCurved;
      if (flat == FlatFaces::kTooMany) return false;
      if (flat == FlatFaces::kCurved && !gather(i, scale)) return false;
    }
    return cut_gathered();
  }

  FaceSet take() { return std::move(set_); }

 private:
  static constexpr double kLinesAtOnce = 1e6;

  bool gather(std::uint32_t item, const ViewScale& scale) {
    auto lattice = ViewLattice::around(view_, scene_.items()[item].shape->bounds(), scale);
    if (!lattice) return true;
    lines_ += lattice->line_count();
    gathered_.push_back({item, *lattice});
    return lines_ < kLinesAtOnce || cut_gathered();
  }

  bool cut_gathered() {
    struct Task {
      std::size_t item;
      NetRow row;
    };
    std::vector<Task> tasks;
    for (std::size_t i = 0; i < gathered_.size(); ++i) {
      for (const NetRow& row : net_rows(gathered_[i].lattice)) tasks.push_back({i, row});
    }
    std::vector<std::vector<NetSample>> found(tasks.size());
    std::atomic<std::size_t> total{0};
    parallel_for(static_cast<std::uint32_t>(tasks.size()), threads_, cancel_, [&](std::uint32_t i) {
      if (total > FaceSet::kMost / 8) return;
      const CurvedItem& curved = gathered_[tasks[i].item];
      sample_row(curved.lattice, tasks[i].row, *scene_.items()[curved.item].shape, found[i]);
      total += found[i].size();
    });
    if (total > FaceSet::kMost / 8) return false;
    std::vector<FaceSet> nets(gathered_.size());
    std::vector<std::size_t> first(gathered_.size() + 1, tasks.size());
    for (std::size_t i = tasks.size(); i-- > 0;) first[tasks[i].item] = i;
    parallel_for(static_cast<std::uint32_t>(nets.size()), threads_, cancel_, [&](std::uint32_t i) {
      std::vector<NetSample> samples;
      for (std::size_t task = first[i]; task < first[i + 1]; ++task) {
        samples.insert(samples.end(), found[task].begin(), found[task].end());
        found[task] = {};
      }
      nets[i] = make_net(view_, gathered_[i].lattice, samples, gathered_[i].item);
    });
    gathered_.clear();
    lines_ = 0;
    return std::all_of(nets.begin(), nets.end(), [&](const FaceSet& net) { return append(net); });
  }

  bool append(const FaceSet& net) {
    if (!set_.has_room(net.corners.size(), net.faces.size())) return false;
    const auto first = static_cast<std::uint32_t>(set_.corners.size());
    set_.corners.insert(set_.corners.end(), net.corners.begin(), net.corners.end());
    for (Face face : net.faces) {
      for (std::uint32_t& corner : face.corners) corner += first;
      set_.faces.push_back(face);
    }
    return true;
  }

  const RenderScene& scene_;
  const ScreenView& view_;
  std::uint32_t threads_;
  const std::atomic<bool>* cancel_;
  std::vector<CurvedItem> gathered_;
  double lines_ = 0;  ///< of the lattices of `gathered_`
  FaceSet set_;
};

}  // namespace

Result<FaceSet> scene_faces(const RenderScene& scene, const ScreenView& view, std::uint32_t threads,
                            const std::atomic<bool>* cancel) {
  FaceBuilder builder(scene, view, threads, cancel);
  if (!builder.add_all()) return too_many_faces();
  return builder.take();
}

}  // namespace dioptre
