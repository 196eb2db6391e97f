// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "dioptre/core/vec.h"
#include "dioptre/scene/scene.h"
#include "dioptre/shading/images/image_sampler.h"
#include "dioptre/shading/noise/noise.h"

namespace dioptre {

/// What some patterns look at beside the point: the surface and the way it is seen.
struct Viewpoint {
  Vec3 normal{0, 1, 0};  ///< unit
  Vec3 view{0, 0, 1};    ///< unit, along the ray
};

/// A pattern before its waves: a number for every point. Continuous patterns give values that the
/// wave stage brings into [0, 1]; block patterns give the number of a block.
class Field {
 public:
  virtual ~Field() = default;
  virtual double value(Vec3 p, const Viewpoint& viewpoint) const = 0;
};

/// What patterns ask of the rest of the texture machinery.
struct PatternServices {
  const Scene* scene = nullptr;
  const std::vector<ImageSampler>* images = nullptr;
  std::function<double(FunctionId, std::span<const double>)> call;
  std::function<PigmentColor(PigmentId, Vec3)> pigment;
  std::function<bool(ObjectId, Vec3)> inside;
};

/// What a pattern is made with beside its own parameters.
struct FieldOptions {
  NoiseGenerator generator = NoiseGenerator::kRangeCorrected;
  Vec3 turbulence;  ///< the amount of the keyword `turbulence`
  Octaves octaves;  ///< of that turbulence
  double frequency = 1, phase = 0;
};

/// Makes the field of a pattern.
std::unique_ptr<const Field> make_field(const PatternData& data, const FieldOptions& options,
                                        const PatternServices& services);

/// True for the patterns that give the number of a block.
bool is_block_pattern(const PatternData& data);

/// True for the patterns that use the keyword `turbulence` in their own way in place of moving the
/// point. (Agate and spirals use it and move the point.)
bool keeps_point(const PatternData& data);

}  // namespace dioptre
