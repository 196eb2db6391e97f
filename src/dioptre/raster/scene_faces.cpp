// SPDX-License-Identifier: Apache-2.0
#include "dioptre/raster/scene_faces.h"

#include <algorithm>
#include <cmath>

#include "dioptre/core/parallel.h"
#include "dioptre/raster/flat_faces.h"
#include "dioptre/raster/hull_faces.h"
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
      if (flat == FlatFaces::kAdded) continue;
      if (primitives[i] && add_hull_faces(view_, *primitives[i], i, set_)) continue;
      if (!gather(i, scale)) return false;
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

  /// A row of the lattice of a gathered item, and what was found along it.
  struct Task {
    std::size_t gathered;
    NetRow row;
    std::vector<NetSample> found;
  };

  bool cut_gathered() {
    std::vector<Task> tasks;
    std::vector<std::size_t> first_task;  // of each gathered item; and the end
    for (std::size_t i = 0; i < gathered_.size(); ++i) {
      first_task.push_back(tasks.size());
      for (const NetRow& row : net_rows(gathered_[i].lattice)) tasks.push_back({i, row, {}});
    }
    first_task.push_back(tasks.size());
    if (!sample(tasks)) return false;
    std::vector<FaceSet> nets(gathered_.size());
    parallel_for(static_cast<std::uint32_t>(nets.size()), threads_, cancel_, [&](std::uint32_t i) {
      std::vector<NetSample> samples;
      for (std::size_t task = first_task[i]; task < first_task[i + 1]; ++task) {
        samples.insert(samples.end(), tasks[task].found.begin(), tasks[task].found.end());
        tasks[task].found = {};
      }
      nets[i] = make_net(view_, gathered_[i].lattice, samples, gathered_[i].item);
    });
    gathered_.clear();
    lines_ = 0;
    return std::all_of(nets.begin(), nets.end(), [&](const FaceSet& net) { return append(net); });
  }

  /// Fills the tasks; false if there would be too much of it.
  bool sample(std::vector<Task>& tasks) const {
    constexpr std::size_t kMost = FaceSet::kMost / 4;
    std::atomic<std::size_t> total{0};
    parallel_for(static_cast<std::uint32_t>(tasks.size()), threads_, cancel_, [&](std::uint32_t i) {
      if (total > kMost) return;
      const CurvedItem& curved = gathered_[tasks[i].gathered];
      sample_row(curved.lattice, tasks[i].row, *scene_.items()[curved.item].shape, tasks[i].found);
      total += tasks[i].found.size();
    });
    return total <= kMost;
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
