// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "dioptre/scene/normal.h"
#include "dioptre/shading/images/image_sampler.h"
#include "dioptre/shading/lookup.h"
#include "dioptre/shading/patterns/field.h"

namespace dioptre {

/// A description of bumps made ready. Immutable.
class NormalEvaluator {
 public:
  virtual ~NormalEvaluator() = default;
  /// The disturbed normal for an undisturbed one; both are covectors of any length in the space of
  /// the lookup.
  virtual Vec3 disturb(const Lookup& at, Vec3 normal) const = 0;
};

/// All normals of a scene, by id.
class NormalTable {
 public:
  /// Makes all normals of the scene ready. The table must not move afterwards: normals that are
  /// made of normals refer to it.
  void compile(const Scene& scene, const std::vector<ImageSampler>& images,
               const PatternServices& services);

  /// A unit normal disturbed, unit again; `normal` itself for no normal, and where the bumps leave
  /// no direction.
  Vec3 disturbed(NormalId id, const Lookup& at, Vec3 normal) const;

  /// As disturbed, but for covectors of any length, and not made unit.
  Vec3 disturb(NormalId id, const Lookup& at, Vec3 normal) const {
    return id.index < normals_.size() ? normals_[id.index]->disturb(at, normal) : normal;
  }

 private:
  std::vector<std::unique_ptr<const NormalEvaluator>> normals_;
};

}  // namespace dioptre
