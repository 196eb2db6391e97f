// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dioptre/core/bounds.h"
#include "dioptre/core/interval.h"
#include "dioptre/core/ray.h"
#include "dioptre/core/result.h"
#include "dioptre/core/scalar_field.h"
#include "dioptre/core/vec.h"

namespace dioptre {

/// Where a ray goes through a surface. Only what finding it yields: the local geometry is computed
/// later, for the one crossing that is seen, by Shape::surface.
struct Crossing {
  double t = 0;
  double error = 0;        ///< a bound on |t - true t|, from the arithmetic (never a scene length)
  std::uint32_t leaf = 0;  ///< which part of a compound shape; set by the compound
  std::uint32_t face = 0;  ///< which face of the shape, in the shape's own numbering
  double u = 0, v = 0;     ///< the shape's own coordinates of the point, if it found them anyway
  bool entering = true;    ///< from outside to inside; for a sheet: against its normal
  bool visible = true;     ///< false: bounds the solid but is not drawn (an `open` cap)
};

using Crossings = std::vector<Crossing>;

/// What one of a shape's own textures counts for at a point; see Shape::texture_shares.
struct TextureShare {
  static constexpr std::uint32_t kWhole = 0xffffffff;
  std::uint32_t part = kWhole;  ///< index into Object::part_textures; kWhole: that of the object
  double share = 1;
};

/// The local geometry of a surface at a crossing, in the shape's own space unless said otherwise.
struct Surface {
  Vec3 position;
  Vec3 normal;          ///< geometric, unit, pointing out of the solid (or to a sheet's front)
  Vec3 shading_normal;  ///< unit; differs from `normal` on smoothed faces only
};

/// The points p with dot(p, normal) <= distance; the normal is a unit vector.
struct HalfSpace {
  Vec3 normal;
  double distance = 0;
};

/// A prepared primitive in its own space: immutable, shared by all threads.
///
/// Rays may have a direction of any length, and any origin. A shape is a solid (it has an inside),
/// or a sheet (a triangle, an open mesh): a sheet contains nothing and never starts inside.
class Shape {
 public:
  virtual ~Shape() = default;

  /// A box that holds every surface point, and every inside point unless it is infinite.
  virtual Bounds bounds() const = 0;

  /// A box that holds what of the shape lies in `region`. Tighter than the common part of both
  /// boxes where an infinite shape is cut to a finite piece (a hyperboloid between two planes).
  virtual Bounds bounds_within(const Bounds& region) const { return intersect(bounds(), region); }

  virtual bool solid() const { return true; }

  /// How long a ray takes with this shape, in about the time that one takes with a sphere: where
  /// several shapes are to be met, the cheap ones are asked first.
  virtual double cost() const { return 10; }

  /// The half-space that this shape is, if it is one.
  virtual std::optional<HalfSpace> half_space() const { return std::nullopt; }

  /// Appends the crossings with range.min < t < range.max to `out`, in order of t, and returns
  /// whether the ray is inside just after range.min. For a solid, the crossings' `entering`
  /// alternate from that state on. A tangent point is either absent or two crossings.
  virtual bool crossings(const Ray& ray, Interval range, Crossings& out) const = 0;

  /// Whether p lies inside; a point on the surface may count either way.
  virtual bool contains(Vec3 p) const = 0;

  /// The geometry at a crossing that `crossings` or `nearest` reported for this very ray.
  virtual Surface surface(const Ray& ray, const Crossing& crossing) const = 0;

  /// The surface coordinates at such a crossing, in [0,1]^2; (0, 0) if the shape has none.
  virtual Vec2 uv(const Ray&, const Crossing&) const { return {}; }

  /// Appends what the textures of the shape's parts count for at such a crossing, 1 in sum; nothing
  /// where only the texture of the whole shows.
  virtual void texture_shares(const Ray&, const Crossing&, std::vector<TextureShare>&) const {}

  /// The first visible crossing in the range; false if there is none. The default asks
  /// `crossings`; shapes override it where they can stop early.
  virtual bool nearest(const Ray& ray, Interval range, Crossing& out) const;
};

using ShapePtr = std::unique_ptr<const Shape>;

/// How shapes are prepared.
struct ShapeOptions {
  /// The structure over the parts of those that have many (meshes).
  std::string accelerator = "bvh";
  /// The functions that shapes are made of, which must outlive the shapes; without, those are
  /// refused.
  const ScalarFields* fields = nullptr;
};

}  // namespace dioptre
