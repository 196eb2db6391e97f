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

/// The half-space dot(p, normal) <= distance, or what is left without it, in world space.
PlacedHalfSpace place(const HalfSpace& half, const Affine& to_object, bool complement) {
  const double sign = complement ? -1 : 1;
  const Affine sizes{abs(to_object.x), abs(to_object.y), abs(to_object.z), abs(to_object.o)};
  return {sign * to_object.covector(half.normal),
          sign * (half.distance - dot(half.normal, to_object.o)), sizes.covector(abs(half.normal)),
          std::fabs(half.distance) + dot(abs(half.normal), sizes.o)};
}

}  // namespace

double rounding_of(const Ray& ray, double t) {
  const double distance = max_component(abs(ray.origin));
  return kPlacementError * (std::fabs(t) + distance / max_component(abs(ray.direction)));
}

PlacedLeaf::PlacedLeaf(const Leaf& leaf)
    : leaf_(leaf),
      convex_(dynamic_cast<const ConvexSolid*>(leaf.shape)),
      moved_(!(leaf.placement.to_object == Affine{})),
      bounds_(transform(leaf.shape->bounds(), leaf.placement.to_world)),
      outside_(inside_beyond_bounds(*leaf.shape) != leaf.complement) {
  const auto half = leaf.shape->half_space();
  if (half) half_space_ = place(*half, leaf.placement.to_object, leaf.complement);
}

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
  out.entering = out.entering != leaf_.complement;
  return true;
}

bool PlacedLeaf::stretch(const Ray& ray, std::uint32_t id, std::array<Crossing, 2>& ends) const {
  ConvexSpan span;
  if (!convex_->stretch(to_object(ray), span)) return false;
  ends = {span.entry(), span.leaving()};
  for (Crossing& end : ends) {
    to_world(ray, end);
    end.leaf = id;
  }
  return true;
}

bool PlacedLeaf::contains(Vec3 p) const {
  return leaf_.shape->contains(moved_ ? leaf_.placement.to_object.point(p) : p) != leaf_.complement;
}

/// A crossing as the shape reported it.
Crossing PlacedLeaf::own(const Crossing& crossing) const {
  Crossing own = crossing;
  own.entering = crossing.entering != leaf_.complement;
  return own;
}

Vec2 PlacedLeaf::uv(const Ray& ray, const Crossing& crossing) const {
  return leaf_.shape->uv(to_object(ray), own(crossing));
}

void PlacedLeaf::texture_shares(const Ray& ray, const Crossing& crossing,
                                std::vector<TextureShare>& out) const {
  leaf_.shape->texture_shares(to_object(ray), own(crossing), out);
}

Surface PlacedLeaf::surface(const Ray& ray, const Crossing& crossing) const {
  Surface surface = leaf_.shape->surface(to_object(ray), own(crossing));
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
