// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "dioptre/core/bounds.h"
#include "dioptre/core/color.h"
#include "dioptre/core/ray.h"
#include "dioptre/scene/scene.h"

namespace dioptre {

/// What a scene language may ask about the things it has described so far (`trace`, `inside`,
/// `min_extent`, calls of functions). The reader is handed one; only the application knows that
/// the renderer answers. Answers are deterministic. Objects and functions already asked about must
/// not be changed afterwards; new ones may be appended to the scene.
class SceneQueries {
 public:
  struct Hit {
    Vec3 position, normal;
  };
  virtual ~SceneQueries() = default;
  /// The first point of the object (in its parent's space) on the ray, if any.
  virtual std::optional<Hit> trace(const Scene& scene, ObjectId object, const Ray& ray) = 0;
  virtual bool inside(const Scene& scene, ObjectId object, Vec3 point) = 0;
  virtual Bounds extent(const Scene& scene, ObjectId object) = 0;
  /// The value of a function; arguments beyond its parameters are ignored, missing ones are 0.
  virtual double call(const Scene& scene, FunctionId function,
                      std::span<const double> arguments) = 0;
  virtual PigmentColor pigment(const Scene& scene, PigmentId pigment, Vec3 point) = 0;
};

}  // namespace dioptre
