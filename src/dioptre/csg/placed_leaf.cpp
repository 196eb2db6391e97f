// SPDX-License-Identifier: Apache-2.0
#include "dioptre/csg/placed_leaf.h"

namespace dioptre::csg {
namespace {

/// Whether a point well outside the box of a shape's surface is inside the shape.
bool inside_beyond_bounds(const Shape& shape) {
  const Bounds box = shape.bounds();
  if (!shape.solid() || box.empty() || !box.finite()) return false;
  const Vec3 beyond = box.max + box.extent() + abs(box.max);
  return is_finite(beyond) && !box.contains(beyond) && shape.contains(beyond);
}

}  // namespace

double rounding_of(const Ray& ray, double t) {
  const double distance = max_component(abs(ray.origin));
  return kPlacementError * (std::fabs(t) + distance / max_component(abs(ray.direction)));
}

PlacedLeaf::PlacedLeaf(const Leaf& leaf)
    : leaf_(leaf),
      moved_(!(leaf.placement.to_object == Affine{})),
      bounds_(transform(leaf.shape->bounds(), leaf.placement.to_world)),
      outside_(inside_beyond_bounds(*leaf.shape) != leaf.complement) {}

void PlacedLeaf::to_world(const Ray& ray, Crossing& crossing) const {
  const double rounding = rounding_of(ray, crossing.t);
  // An error that is not a number counts as none.
  crossing.error = crossing.error > 0 ? crossing.error + rounding : rounding;
  crossing.entering = crossing.entering != leaf_.complement;
}

Bounds PlacedLeaf::bounds_within(const Bounds& region) const {
  const Bounds common = intersect(bounds_, region);
  if (outside_ || leaf_.complement || common.empty()) return common;
  const Bounds inner = leaf_.shape->bounds_within(transform(common, leaf_.placement.to_object));
  return intersect(common, transform(inner, leaf_.placement.to_world));
}

std::optional<HalfSpace> PlacedLeaf::half_space() const {
  std::optional<HalfSpace> half = leaf_.shape->half_space();
  if (!half || !moved_) return leaf_.complement ? std::nullopt : half;
  const Vec3 point = leaf_.placement.to_world.point(half->distance * half->normal);
  half->normal = normalize(leaf_.placement.to_object.covector(half->normal));
  half->distance = dot(point, half->normal);
  if (leaf_.complement || !is_finite(half->normal) || !std::isfinite(half->distance)) return {};
  return half;
}

bool PlacedLeaf::crossings(const Ray& ray, Interval range, std::uint32_t id, Crossings& out) const {
  const std::size_t first = out.size();
  const bool inside = leaf_.shape->crossings(to_object(ray), range, out);
  for (std::size_t i = first; i < out.size(); ++i) {
    to_world(ray, out[i]);
    out[i].leaf = id;
  }
  return inside != leaf_.complement;
}

bool PlacedLeaf::nearest(const Ray& ray, Interval range, Crossing& out) const {
  if (!leaf_.shape->nearest(to_object(ray), range, out)) return false;
  to_world(ray, out);
  return true;
}

bool PlacedLeaf::contains(Vec3 p) const {
  return leaf_.shape->contains(moved_ ? leaf_.placement.to_object.point(p) : p) != leaf_.complement;
}

Surface PlacedLeaf::surface(const Ray& ray, const Crossing& crossing) const {
  Crossing own = crossing;
  own.entering = crossing.entering != leaf_.complement;
  Surface surface = leaf_.shape->surface(to_object(ray), own);
  if (moved_) {
    const Affine& back = leaf_.placement.to_object;
    surface.position = leaf_.placement.to_world.point(surface.position);
    surface.normal = normalize(back.covector(surface.normal));
    surface.shading_normal = normalize(back.covector(surface.shading_normal));
  }
  if (leaf_.complement) {
    surface.normal = -surface.normal;
    surface.shading_normal = -surface.shading_normal;
  }
  return surface;
}

}  // namespace dioptre::csg
