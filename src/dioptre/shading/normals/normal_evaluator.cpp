// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/normals/normal_evaluator.h"

#include <cmath>
#include <numbers>

#include "dioptre/shading/maps/position_map.h"
#include "dioptre/shading/normals/bumps.h"
#include "dioptre/shading/normals/slope_map.h"
#include "dioptre/shading/patterns/pattern_evaluator.h"
#include "dioptre/shading/space.h"

namespace dioptre {
namespace {

/// The unit vector along v, or `otherwise` if v has no direction.
Vec3 unit_or(Vec3 v, Vec3 otherwise) {
  const double size = length(v);
  return size > 0 && std::isfinite(size) ? v / size : otherwise;
}

/// How steep a normal makes its bumps.
struct Steepness {
  double amount, accuracy;
  bool scales;  ///< scaling the bumps does not change their steepness

  Steepness(const Normal& normal, double own_amount)
      : amount(normal.has_bump_size ? normal.bump_size : own_amount),
        accuracy(normal.accuracy),
        scales(!normal.no_bump_scale) {}
};

/// amount (0.1 / accuracy) sum of v height(p + accuracy v) over the four corners v of a
/// tetrahedron: about amount times 2/15 of the gradient.
template <class Height>
Vec3 slope(Vec3 p, const Steepness& steepness, Height height) {
  constexpr double kHigh = 2 * std::numbers::sqrt2 / 3, kSide = 0.81649658092772603;  // sqrt(2/3)
  constexpr Vec3 kCorners[4] = {{kHigh, -1.0 / 3, 0},
                                {0, 1, 0},
                                {-kHigh / 2, -1.0 / 3, kSide},
                                {-kHigh / 2, -1.0 / 3, -kSide}};
  Vec3 sum;
  for (const Vec3& corner : kCorners) sum += height(p + steepness.accuracy * corner) * corner;
  return steepness.amount * (0.1 / steepness.accuracy) * sum;
}

/// Bumps made by vectors that are added to the normal.
class VectorBumps final : public NormalEvaluator {
 public:
  VectorBumps(const Normal& normal, const PatternNormal& bumps, const Settings& settings)
      : steepness_(normal, bumps.amount),
        warps_(bumps.pattern.warps, false),
        space_(warps_.transform()),
        bump_(bumps.pattern, noise_generator_of(bumps.pattern, settings),
              settings.number_of_waves) {}
  Vec3 disturb(const Lookup& at, Vec3 normal) const override {
    Vec3 n = space_.normal_inside(normal);
    if (steepness_.scales) n = unit_or(n, n);
    return space_.normal_outside(n + steepness_.amount * bump_.at(warps_.apply(at.position)));
  }

 private:
  Steepness steepness_;
  WarpList warps_;
  Space space_;
  Bump bump_;
};

/// Bumps made by the heights of a pattern.
class PatternBumps final : public NormalEvaluator {
 public:
  PatternBumps(const Normal& normal, const PatternNormal& bumps, const PatternServices& services)
      : steepness_(normal, bumps.amount),
        pattern_(bumps.pattern, services),
        space_(pattern_.warps().transform()),
        profile_(bumps.slope_map) {}
  Vec3 disturb(const Lookup& at, Vec3 normal) const override {
    Vec3 n = space_.normal_inside(normal);
    if (steepness_.scales) n = unit_or(n, n);
    const auto height = [&](Vec3 p) {
      return profile_.height(pattern_.value_inside(p, at.viewpoint));
    };
    return space_.normal_outside(n -
                                 slope(pattern_.warps().apply(at.position), steepness_, height));
  }

 private:
  Steepness steepness_;
  PatternEvaluator pattern_;
  Space space_;
  SlopeMap profile_;
};

/// Bumps made by the heights of an image, leaning in the plane across the normal whose axes are
/// horizontal and upright.
class ImageBumps final : public NormalEvaluator {
 public:
  ImageBumps(const Normal& normal, const BumpMapNormal& bumps, const ImageSampler& image)
      : steepness_(normal, bumps.amount),
        image_(image),
        warps_(bumps.warps, false),
        space_(warps_.transform()) {}
  Vec3 disturb(const Lookup& at, Vec3 normal) const override {
    const auto lean = image_.lean(warps_.apply(at.position));
    if (!lean) return normal;
    Vec3 n = space_.normal_inside(normal);
    if (steepness_.scales) n = unit_or(n, n);
    const Vec3 across = unit_or(cross(n, {0, 1, 0}), {1, 0, 0});
    const Vec3 up = unit_or(cross(across, n), {0, 0, 1});
    return space_.normal_outside(n + steepness_.amount * (lean->x * across + lean->y * up));
  }

 private:
  Steepness steepness_;
  const ImageSampler& image_;
  WarpList warps_;
  Space space_;
};

class Flat final : public NormalEvaluator {
 public:
  Vec3 disturb(const Lookup&, Vec3 normal) const override { return normal; }
};

/// Its normals live in the space inside the pattern's warps.
class NormalMap final : public NormalEvaluator {
 public:
  NormalMap(const NormalMapNormal& map, const NormalTable& table, const PatternServices& services)
      : table_(table),
        pattern_(map.pattern, services),
        space_(pattern_.warps().transform()),
        places_(map.entries, map.list) {
    for (const NormalEntry& entry : map.entries) normals_.push_back(entry.normal);
  }
  Vec3 disturb(const Lookup& at, Vec3 normal) const override {
    const Nesting nesting;
    if (normals_.empty() || nesting.too_deep()) return normal;
    const Lookup inside = at.at(pattern_.warps().apply(at.position));
    const MapPlace place = places_.find(pattern_.value_inside(inside.position, at.viewpoint));
    const NormalId first = normals_[place.first], second = normals_[place.second];
    const Vec3 n = space_.normal_inside(normal);
    const auto of = [&](NormalId id) { return unit_or(table_.disturb(id, inside, n), n); };
    if (place.share == 0 || first == second) return space_.normal_outside(of(first));
    if (place.share == 1) return space_.normal_outside(of(second));
    return space_.normal_outside((1.0 - place.share) * of(first) + place.share * of(second));
  }

 private:
  const NormalTable& table_;
  PatternEvaluator pattern_;
  Space space_;
  PositionMap places_;
  std::vector<NormalId> normals_;
};

class Average final : public NormalEvaluator {
 public:
  Average(const AverageNormal& average, const NormalTable& table)
      : table_(table),
        warps_(average.warps, false),
        space_(warps_.transform()),
        weights_(average_weights(average.entries)) {
    for (const NormalEntry& entry : average.entries) normals_.push_back(entry.normal);
  }
  Vec3 disturb(const Lookup& at, Vec3 normal) const override {
    const Nesting nesting;
    if (normals_.empty() || nesting.too_deep()) return normal;
    const Lookup inside = at.at(warps_.apply(at.position));
    const Vec3 n = space_.normal_inside(normal);
    Vec3 sum;
    for (std::size_t i = 0; i < normals_.size(); ++i) {
      if (weights_[i] == 0) continue;
      sum += weights_[i] * unit_or(table_.disturb(normals_[i], inside, n), n);
    }
    return space_.normal_outside(sum);
  }

 private:
  const NormalTable& table_;
  WarpList warps_;
  Space space_;
  std::vector<float> weights_;
  std::vector<NormalId> normals_;
};

class OnSurface final : public NormalEvaluator {
 public:
  OnSurface(NormalId normal, const NormalTable& table) : table_(table), normal_(normal) {}
  Vec3 disturb(const Lookup& at, Vec3 normal) const override {
    const Nesting nesting;
    return nesting.too_deep() ? normal : table_.disturb(normal_, at.at_uv(), normal);
  }

 private:
  const NormalTable& table_;
  NormalId normal_;
};

struct Maker {
  const Normal& normal;
  const NormalTable& table;
  const std::vector<ImageSampler>& images;
  const PatternServices& services;
  using Made = std::unique_ptr<const NormalEvaluator>;

  Made operator()(const PatternNormal& bumps) const {
    if (Steepness(normal, bumps.amount).amount == 0) return std::make_unique<Flat>();
    if (Bump::exists_for(bumps.pattern.data)) {
      return std::make_unique<VectorBumps>(normal, bumps, services.scene->settings);
    }
    return std::make_unique<PatternBumps>(normal, bumps, services);
  }
  Made operator()(const NormalMapNormal& map) const {
    return std::make_unique<NormalMap>(map, table, services);
  }
  Made operator()(const AverageNormal& average) const {
    return std::make_unique<Average>(average, table);
  }
  Made operator()(const BumpMapNormal& bumps) const {
    if (bumps.image.index >= images.size()) return std::make_unique<Flat>();
    return std::make_unique<ImageBumps>(normal, bumps, images[bumps.image.index]);
  }
  Made operator()(const UvNormal& uv) const {
    return std::make_unique<OnSurface>(uv.normal, table);
  }
};

}  // namespace

void NormalTable::compile(const Scene& scene, const std::vector<ImageSampler>& images,
                          const PatternServices& services) {
  normals_.reserve(scene.normals.size());
  for (const Normal& normal : scene.normals) {
    normals_.push_back(std::visit(Maker{normal, *this, images, services}, normal.data));
  }
}

Vec3 NormalTable::disturbed(NormalId id, const Lookup& at, Vec3 normal) const {
  return id ? unit_or(disturb(id, at, normal), normal) : normal;
}

}  // namespace dioptre
