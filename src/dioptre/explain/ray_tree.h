// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dioptre/core/result.h"
#include "dioptre/csg/explain.h"
#include "dioptre/integrators/eye_rays.h"
#include "dioptre/integrators/integrator.h"

namespace dioptre {

/// The surface that a ray of the tree meets.
struct Meeting {
  double distance = 0;
  Vec3 position, normal, shading_normal;  ///< the normals face the ray
  double angle = 0;                       ///< of the ray to the shading normal, radians
  ObjectId object;                        ///< the primitive
  std::size_t item = 0;                   ///< of RenderScene::items
  std::vector<ObjectId> leaves;           ///< the object of each primitive in `stretches`
  csg::RayStretches stretches;            ///< of the item along the ray
  std::vector<SurfaceLayer> layers;       ///< of its texture, the top one first
};

/// Light that a ray brings back of itself.
struct Received {
  LightTerm term;
  Vec3 light;
};

/// All shadow rays from one surface to one light.
struct LightSeen {
  std::size_t light = 0;  ///< its number in the scene
  std::uint32_t rays = 0, blocked = 0;
  Vec3 visible;                     ///< the mean of what gets through
  std::optional<ObjectId> blocker;  ///< the first part of an item that blocks
};

/// One ray and those that it gave rise to.
struct TreeRay {
  RayStart start;
  std::int32_t parent = -1;  ///< an earlier ray; -1: it is the eye's
  std::vector<std::uint32_t> children;
  std::optional<Meeting> meeting;  ///< nothing if it runs into the sky
  std::vector<Received> received;
  std::vector<LightSeen> lights;
  Vec3 own;    ///< the sum of `received`
  Vec3 light;  ///< the same and what the children bring
};

/// Everything that happened for one pixel.
struct RayTree {
  std::uint32_t column = 0, row = 0, width = 0, height = 0;
  std::vector<TreeRay> rays;  ///< the eye's first, parents before children
  Color value;                ///< of the pixel, as the integrator gives it
  /// How far the sum of all contributions is from the value, relative to 1 or the value if that is
  /// larger.
  double gap() const;
};

/// What to explain.
struct ExplainOptions {
  std::uint32_t column = 0, row = 0;  ///< from 0, the top left
  std::uint32_t width = 320, height = 240;
  std::string integrator = "whitted";
  IntegratorOptions integrator_options;
};

/// Follows the ray through the middle of a pixel, for a camera with a lens through its middle. An
/// error for a pixel outside the image, where the camera shows nothing, and for an unknown
/// integrator.
Result<RayTree> explain_pixel(const RenderScene& scene, const ExplainOptions& options);

}  // namespace dioptre
