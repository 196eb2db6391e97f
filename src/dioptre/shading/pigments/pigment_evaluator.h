// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "dioptre/scene/pigment.h"
#include "dioptre/shading/images/image_sampler.h"
#include "dioptre/shading/lookup.h"
#include "dioptre/shading/patterns/field.h"

namespace dioptre {

/// A pigment made ready. Immutable.
class PigmentEvaluator {
 public:
  virtual ~PigmentEvaluator() = default;
  virtual PigmentColor color(const Lookup& at) const = 0;
};

/// All pigments of a scene, by id.
class PigmentTable {
 public:
  /// Makes all pigments of the scene ready. The table must not move afterwards: pigments that are
  /// made of pigments, and the services, refer to it.
  void compile(const Scene& scene, const std::vector<ImageSampler>& images,
               const PatternServices& services);

  /// The colour at a point; black and opaque for no pigment.
  PigmentColor color(PigmentId id, const Lookup& at) const {
    return id.index < pigments_.size() ? pigments_[id.index]->color(at) : PigmentColor{};
  }

  /// True if the pigment lets no light through anywhere. May be false where it could be true.
  bool opaque(PigmentId id) const { return id.index >= opaque_.size() || opaque_[id.index]; }

 private:
  void find_opaque(const Scene& scene, const std::vector<ImageSampler>& images);

  std::vector<std::unique_ptr<const PigmentEvaluator>> pigments_;
  std::vector<bool> opaque_;
};

}  // namespace dioptre
