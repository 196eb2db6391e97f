// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "dioptre/core/rng.h"
#include "dioptre/csg/tree.h"

namespace dioptre::csg {

/// A solid that a ray meets in one interval: what the tests of this folder build on.
class ConvexShape : public Shape {
 public:
  virtual Interval inside(const Ray& ray) const = 0;
  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    const Interval in = inside(ray);
    if (!(in.min < in.max)) return false;
    if (range.surrounds(in.min)) out.push_back({.t = in.min, .error = error(in.min)});
    if (range.surrounds(in.max)) {
      out.push_back({.t = in.max, .error = error(in.max), .entering = false});
    }
    return in.min <= range.min && range.min < in.max;
  }

 private:
  static double error(double t) { return 1e-15 * std::fabs(t); }
};

class Ball final : public ConvexShape {
 public:
  explicit Ball(double radius = 1) : radius_(radius) {}
  Bounds bounds() const override {
    return {{-radius_, -radius_, -radius_}, {radius_, radius_, radius_}};
  }
  bool contains(Vec3 p) const override { return dot(p, p) < radius_ * radius_; }
  Interval inside(const Ray& ray) const override {
    const double a = dot(ray.direction, ray.direction);
    const double middle = -dot(ray.origin, ray.direction) / a;
    const Vec3 closest = ray.at(middle);
    const double square = (radius_ * radius_ - dot(closest, closest)) / a;
    if (!(square > 0)) return {};
    return {middle - std::sqrt(square), middle + std::sqrt(square)};
  }
  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    const Vec3 p = ray.at(crossing.t);
    return {p, normalize(p), normalize(p)};
  }

 private:
  double radius_;
};

/// A box; with infinite sides also a slab or a half-space.
class Block final : public ConvexShape {
 public:
  explicit Block(Vec3 min = {-1, -1, -1}, Vec3 max = {1, 1, 1}) : box_{min, max} {}
  Bounds bounds() const override { return box_; }
  bool contains(Vec3 p) const override { return box_.contains(p); }
  Interval inside(const Ray& ray) const override {
    Interval in = Interval::all();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double d = ray.direction[axis], o = ray.origin[axis];
      if (d == 0 && !(box_.min[axis] < o && o < box_.max[axis])) return {};
      if (d == 0) continue;
      const double one = (box_.min[axis] - o) / d, two = (box_.max[axis] - o) / d;
      in = intersect(in, {std::min(one, two), std::max(one, two)});
    }
    return in;
  }
  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    const Vec3 p = ray.at(crossing.t);
    Surface surface{p, {}, {}};
    double best = kInfinity;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        const double off = std::fabs(p[axis] - (side < 0 ? box_.min : box_.max)[axis]);
        if (!(off < best)) continue;
        best = off;
        surface.normal = {};
        surface.normal[axis] = side;
      }
    }
    surface.shading_normal = surface.normal;
    return surface;
  }

 private:
  Bounds box_;
};

/// An infinite cylinder of radius 1 about z.
class Tube final : public ConvexShape {
 public:
  Bounds bounds() const override { return {{-1, -1, -kInfinity}, {1, 1, kInfinity}}; }
  bool contains(Vec3 p) const override { return p.x * p.x + p.y * p.y < 1; }
  Interval inside(const Ray& ray) const override {
    const Vec3 o{ray.origin.x, ray.origin.y, 0}, d{ray.direction.x, ray.direction.y, 0};
    if (dot(d, d) == 0) return dot(o, o) < 1 ? Interval::all() : Interval{};
    return Ball().inside({o, d});
  }
  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    const Vec3 p = ray.at(crossing.t), n = normalize({p.x, p.y, 0});
    return {p, n, n};
  }
};

/// The square [-2,2]^2 in z = 0, seen from both sides.
class Square final : public Shape {
 public:
  Bounds bounds() const override { return {{-2, -2, 0}, {2, 2, 0}}; }
  bool solid() const override { return false; }
  bool contains(Vec3) const override { return false; }
  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    const double t = -ray.origin.z / ray.direction.z;
    const Vec3 p = ray.at(t);
    if (range.surrounds(t) && std::fabs(p.x) <= 2 && std::fabs(p.y) <= 2) {
      out.push_back({.t = t, .error = 1e-15 * std::fabs(t), .entering = ray.direction.z < 0});
    }
    return false;
  }
  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    return {ray.at(crossing.t), {0, 0, 1}, {0, 0, 1}};
  }
};

/// Writes descriptions, and keeps their shapes.
class Writer {
 public:
  Description description;

  template <class Kind>
  std::int32_t leaf(Kind shape, const Affine& to_world = {}) {
    shapes_.push_back(std::make_unique<Kind>(std::move(shape)));
    description.leaves.push_back({shapes_.back().get(), {to_world, *inverse(to_world)}});
    return ~static_cast<std::int32_t>(description.leaves.size() - 1);
  }
  std::int32_t ball(Vec3 center, double radius) { return leaf(Ball(radius), translation(center)); }
  std::int32_t block(Vec3 min, Vec3 max) { return leaf(Block(min, max)); }
  std::int32_t node(Operation operation, std::vector<std::int32_t> children) {
    description.nodes.push_back({operation, std::move(children)});
    return static_cast<std::int32_t>(description.nodes.size() - 1);
  }
  std::int32_t merge(std::int32_t a, std::int32_t b) { return node(Operation::kMerge, {a, b}); }
  std::int32_t common(std::int32_t a, std::int32_t b) {
    return node(Operation::kIntersection, {a, b});
  }
  std::int32_t inverted(std::int32_t a) {
    complement(description, a);
    return a;
  }
  std::int32_t difference(std::int32_t a, std::int32_t b) { return common(a, inverted(b)); }
  /// Makes `entry` the root and compiles.
  ShapePtr solid(std::int32_t entry) {
    description.root = entry;
    return build(description);
  }

 private:
  std::vector<ShapePtr> shapes_;
};

/// Random numbers for tests.
struct Random {
  std::uint64_t state = 0;
  double unit() { return to_unit(mix_bits(state++)); }
  double between(double a, double b) { return a + (b - a) * unit(); }
  int below(int n) { return static_cast<int>(unit() * n); }
  Vec3 point(double size) {
    return {between(-size, size), between(-size, size), between(-size, size)};
  }
  Ray ray(double size) { return {point(size), normalize(point(1))}; }
};

/// The places of all crossings of a ray.
inline std::vector<double> times(const Shape& shape, const Ray& ray,
                                 Interval range = Interval::all()) {
  Crossings crossings;
  shape.crossings(ray, range, crossings);
  std::vector<double> t;
  for (const Crossing& crossing : crossings) t.push_back(crossing.t);
  return t;
}

/// The length of the ray inside a solid with alternating crossings.
inline double length_inside(const Shape& shape, const Ray& ray) {
  double sum = 0;
  Crossings crossings;
  shape.crossings(ray, Interval::all(), crossings);
  for (const Crossing& crossing : crossings) sum += crossing.entering ? -crossing.t : crossing.t;
  return sum;
}

}  // namespace dioptre::csg
