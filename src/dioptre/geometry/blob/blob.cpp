// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/blob/blob.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "dioptre/accel/bounding_volume_hierarchy.h"
#include "dioptre/geometry/blob/field.h"

namespace dioptre {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon() / 2;

/// Reused from ray to ray by each thread, so that no ray allocates.
struct Workspace {
  std::vector<FieldPiece> pieces;
  std::vector<std::uint32_t> active;
  std::vector<double> cuts;
};

Workspace& workspace() {
  thread_local Workspace space;
  return space;
}

class PreparedBlob final : public Shape {
 public:
  PreparedBlob(double threshold, std::vector<FieldComponent> components)
      : threshold_(threshold), components_(std::move(components)) {
    std::vector<Bounds> boxes;
    boxes.reserve(components_.size());
    for (const FieldComponent& c : components_) {
      boxes.push_back(c.bounds);
      textured_ = textured_ || c.texture != TextureShare::kWhole;
      if ((c.strength > 0) == (threshold_ >= 0)) bounds_ = unite(bounds_, c.bounds);
    }
    tree_ = BoundingVolumeHierarchy(boxes);
  }

  Bounds bounds() const override { return bounds_; }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    return walk(ray, range, [&](const Crossing& crossing) {
      out.push_back(crossing);
      return true;
    });
  }

  bool nearest(const Ray& ray, Interval range, Crossing& out) const override {
    bool found = false;
    walk(ray, range, [&](const Crossing& crossing) {
      out = crossing;
      found = true;
      return false;
    });
    return found;
  }

  bool contains(Vec3 p) const override {
    if (!bounds_.contains(p)) return 0 > threshold_;
    double sum = 0;
    tree_.visit_at(p, [&](std::uint32_t i) { sum += field_at(components_[i], p); });
    return sum > threshold_;
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    Surface s;
    s.position = ray.at(crossing.t);
    Vec3 gradient;
    tree_.visit_at(s.position,
                   [&](std::uint32_t i) { field_at(components_[i], s.position, &gradient); });
    const double size = max_component(abs(gradient));
    const Vec3 against = crossing.entering ? -ray.direction : ray.direction;
    s.normal = normalize(size > 0 && std::isfinite(size) ? gradient / -size : against);
    s.shading_normal = s.normal;
    return s;
  }

  /// Textures count as their components do, those that take away too (measured).
  void texture_shares(const Ray& ray, const Crossing& crossing,
                      std::vector<TextureShare>& out) const override {
    if (!textured_) return;
    const Vec3 p = ray.at(crossing.t);
    const std::size_t first = out.size();
    double sum = 0;
    tree_.visit_at(p, [&](std::uint32_t i) {
      const double share = std::fabs(field_at(components_[i], p));
      if (share > 0) out.push_back({components_[i].texture, share});
      sum += share;
    });
    for (std::size_t i = first; i < out.size(); ++i) out[i].share /= sum;
  }

 private:
  /// Goes along the ray from cut to cut, between which the field is one quartic; calls
  /// sink(crossing) until it returns false. Returns whether the ray starts inside.
  template <class Sink>
  bool walk(const Ray& ray, Interval range, Sink&& sink) const;

  /// The threshold less the field of the active pieces on [ta, tb]: negative inside. Also how
  /// large its rounding error may be.
  Bernstein<4> shortfall(const Workspace& space, double ta, double tb, double& error) const {
    Bernstein<4> sum;
    sum.fill(threshold_);
    double size = std::fabs(threshold_);
    for (const std::uint32_t i : space.active) {
      const FieldPiece& piece = space.pieces[i];
      const Bernstein<4> field = piece.field(ta, tb);
      for (std::size_t k = 0; k < 5; ++k) sum[k] -= field[k];
      const double far = 1 + max_component(abs(piece.ray.origin));
      size += std::fabs(piece.strength) * far;
    }
    error = 64 * kEpsilon * size;
    return sum;
  }

  static std::uint32_t strongest(const Workspace& space, double t) {
    std::uint32_t best = 0;
    double most = -kInfinity;
    for (const std::uint32_t i : space.active) {
      const double field = space.pieces[i].field(t, t)[0];
      if (field > most || (field == most && space.pieces[i].index < best)) {
        most = field;
        best = space.pieces[i].index;
      }
    }
    return best;
  }

  void gather(const Ray& ray, Interval range, Workspace& space) const {
    space.pieces.clear();
    space.active.clear();
    Interval rest = range;
    tree_.traverse(ray, rest, [&](std::uint32_t i, Interval&) {
      append_pieces(components_[i], ray, space.pieces);
      return true;
    });
    std::sort(space.pieces.begin(), space.pieces.end(),
              [](const FieldPiece& a, const FieldPiece& b) {
                return a.begin != b.begin ? a.begin < b.begin : a.index < b.index;
              });
    space.cuts.assign({range.min, range.max});
    for (const FieldPiece& piece : space.pieces) {
      if (range.surrounds(piece.begin)) space.cuts.push_back(piece.begin);
      if (range.surrounds(piece.end)) space.cuts.push_back(piece.end);
    }
    std::sort(space.cuts.begin(), space.cuts.end());
  }

  double threshold_;
  std::vector<FieldComponent> components_;
  bool textured_ = false;  ///< some of them have a texture of their own
  BoundingVolumeHierarchy tree_;
  Bounds bounds_;
};

template <class Sink>
bool PreparedBlob::walk(const Ray& ray, Interval range, Sink&& sink) const {
  const bool far_inside = 0 > threshold_;
  // Where quartics are solved does not depend on the range, and so neither do their roots' bits.
  const Interval near = clip(bounds_, ray, Interval::all());
  if (near.empty() || !std::isfinite(near.min) || !std::isfinite(near.max)) return far_inside;
  if (near.max <= range.min || near.min >= range.max) return far_inside;

  // The ray is moved to where the blob begins: from there on numbers are small.
  const double shift = near.min;
  const Ray moved{ray.at(shift), ray.direction};
  Workspace& space = workspace();
  gather(moved, {0, near.max - shift}, space);

  const double position_error = 2 * kEpsilon *
                                (length(ray.origin) + std::fabs(shift) * length(ray.direction)) /
                                length(ray.direction);
  bool inside = far_inside, start_inside = far_inside, first = true;
  double last = -kInfinity;
  const auto report = [&](double t, double error) {
    inside = !inside;
    Crossing crossing;
    crossing.t = last = std::max(shift + t, last);
    if (crossing.t <= range.min) start_inside = inside;
    if (!range.surrounds(crossing.t)) return crossing.t <= range.min;
    crossing.error = error + position_error + 2 * kEpsilon * (std::fabs(shift) + std::fabs(t));
    crossing.face = strongest(space, t);
    crossing.entering = inside;
    return sink(crossing);
  };

  std::size_t next = 0;
  for (std::size_t i = 0; i + 1 < space.cuts.size(); ++i) {
    const double ta = space.cuts[i], tb = space.cuts[i + 1];
    if (ta == tb) continue;
    if (shift + ta >= range.max) return start_inside;
    while (next < space.pieces.size() && space.pieces[next].begin <= ta) {
      space.active.push_back(static_cast<std::uint32_t>(next++));
    }
    std::erase_if(space.active, [&](std::uint32_t p) { return space.pieces[p].end <= ta; });
    if (shift + tb <= range.min) continue;
    double error = 0;
    const Bernstein<4> f = shortfall(space, ta, tb, error);
    if (first && i > 0) inside = start_inside = f[0] < 0;
    first = false;
    // Where two quartics meet they may differ by rounding; the state is carried on.
    if ((f[0] < 0) != inside && !report(ta, 0)) return start_inside;
    const SignChanges<4> changes = sign_changes<4>(f);
    const PowerBasis<4> power(f);
    for (std::size_t k = 0; k < changes.count; ++k) {
      const double s = changes.at[k].s;
      const double spread = std::min(error / std::fabs(power.slope(s)), 1.0) * (tb - ta);
      if (!report(ta + s * (tb - ta), spread)) return start_inside;
    }
  }
  if (inside != far_inside) report(near.max - shift, 0);
  return start_inside;
}

}  // namespace

Result<ShapePtr> prepare(const Blob& blob) {
  if (!std::isfinite(blob.threshold)) return fail("blob threshold is not finite");
  if (blob.components.empty()) return fail("blob needs at least one component");
  Result<std::vector<FieldComponent>> components = field_components(blob);
  if (!components) return tl::unexpected<Error>(components.error());
  return std::make_unique<PreparedBlob>(blob.threshold, std::move(*components));
}

}  // namespace dioptre
