// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/isosurface/isosurface.h"

#include <algorithm>
#include <cmath>

#include "dioptre/geometry/isosurface/line_search.h"
#include "dioptre/geometry/quadratic.h"

namespace dioptre {
namespace {

/// The part of a ray in the container, of s from 0 to 1.
struct Stretch {
  Crossing in, out;
  Vec3 origin, step;

  double length() const { return out.t - in.t; }
  double t(double s) const { return std::clamp(in.t + s * length(), in.t, out.t); }
  double s(double t) const { return (t - in.t) / length(); }
};

class PreparedIsosurface final : public Shape {
 public:
  PreparedIsosurface(const Isosurface& data, ShapePtr container,
                     std::unique_ptr<const ScalarField> field)
      : container_(std::move(container)),
        field_(std::move(field)),
        threshold_(data.threshold),
        accuracy_(data.accuracy > 0 ? data.accuracy : Isosurface{}.accuracy),
        steepest_(stated_gradient(data)),
        open_(data.open) {}

  Bounds bounds() const override { return container_->bounds(); }
  double cost() const override { return 200; }

  bool contains(Vec3 p) const override {
    if (!container_->contains(p)) return false;
    return value(p) < threshold_;
  }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    Stretch stretch;
    if (!stretch_of(ray, range, stretch)) return false;
    const FieldLine line(*field_, threshold_, stretch.origin, stretch.step);
    LineSearch search = search_along(line, stretch, range);
    SignChange change;
    bool more = search.next(change);
    bool inside = stretch.in.t <= range.min && search.began_inside();
    const auto report = [&](const Crossing& crossing) {
      if (crossing.t <= range.min) inside = crossing.entering;
      if (range.surrounds(crossing.t)) out.push_back(crossing);
    };
    if (search.first_inside() && stretch.in.t > range.min) report(cap(stretch.in));
    for (; more; more = search.next(change)) report(crossing_at(ray, stretch, change));
    if (search.last_inside()) report(cap(stretch.out));
    return inside;
  }

  bool nearest(const Ray& ray, Interval range, Crossing& out) const override {
    Stretch stretch;
    if (!stretch_of(ray, range, stretch)) return false;
    const FieldLine line(*field_, threshold_, stretch.origin, stretch.step);
    LineSearch search = search_along(line, stretch, range);
    const auto found = [&](const Crossing& crossing) {
      out = crossing;
      return crossing.visible && range.surrounds(crossing.t);
    };
    if (search.first_inside() && found(cap(stretch.in))) return true;
    SignChange change;
    while (search.next(change)) {
      if (found(crossing_at(ray, stretch, change))) return true;
    }
    return search.last_inside() && found(cap(stretch.out));
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    if (crossing.face > 0) {
      Crossing of_container = crossing;
      --of_container.face;
      return container_->surface(ray, of_container);
    }
    const Vec3 p = ray.at(crossing.t);
    Vec3 normal = gradient(p);
    const double size = max_component(abs(normal));
    if (!(size > 0) || !std::isfinite(size)) {
      normal = normalize(crossing.entering ? -ray.direction : ray.direction);
    } else {
      normal = normalize(normal / size);
    }
    return {p, normal, normal};
  }

  Vec2 uv(const Ray& ray, const Crossing& crossing) const override {
    if (crossing.face == 0) return {};
    Crossing of_container = crossing;
    --of_container.face;
    return container_->uv(ray, of_container);
  }

 private:
  static double stated_gradient(const Isosurface& data) {
    const double found =
        data.evaluate ? data.least_gradient * std::max(data.overestimate * data.overestimate, 1.0)
                      : data.max_gradient;
    return found > 0 ? std::min(found, 1e100) : 0;
  }

  double value(Vec3 p) const {
    const double arguments[] = {p.x, p.y, p.z};
    return field_->value(arguments);
  }

  /// By differences over the accuracy.
  Vec3 gradient(Vec3 p) const {
    const double h = accuracy_, here = value(p);
    return {value({p.x + h, p.y, p.z}) - here, value({p.x, p.y + h, p.z}) - here,
            value({p.x, p.y, p.z + h}) - here};
  }

  bool stretch_of(const Ray& ray, Interval range, Stretch& stretch) const {
    thread_local Crossings found;
    found.clear();
    container_->crossings(ray, Interval::all(), found);
    if (found.size() < 2) return false;
    stretch.in = found.front();
    stretch.out = found.back();
    if (!(stretch.in.t < range.max && stretch.out.t > range.min)) return false;
    if (!(stretch.in.t < stretch.out.t)) return false;
    stretch.origin = ray.at(stretch.in.t);
    stretch.step = stretch.length() * ray.direction;
    return is_finite(stretch.origin) && is_finite(stretch.step);
  }

  LineSearch search_along(const FieldLine& line, const Stretch& stretch, Interval range) const {
    const double size = length(stretch.step);
    return {line, steepest_ * size, accuracy_ / size, {stretch.s(range.min), stretch.s(range.max)}};
  }

  Crossing cap(Crossing crossing) const {
    ++crossing.face;
    crossing.visible = !open_;
    return crossing;
  }

  static Crossing crossing_at(const Ray& ray, const Stretch& stretch, const SignChange& change) {
    const double t = stretch.t(change.s);
    const double error =
        change.error * stretch.length() + shift_error(ray, t) + 8 * kRounding * std::fabs(t);
    return {.t = t, .error = error, .entering = change.inside};
  }

  ShapePtr container_;
  std::unique_ptr<const ScalarField> field_;
  double threshold_, accuracy_, steepest_;
  bool open_;
};

}  // namespace

Result<ShapePtr> prepare(const Isosurface& data, const ShapeOptions& options) {
  if (!std::isfinite(data.threshold)) return fail("isosurface: the threshold is not finite");
  auto container = prepare(data.container);
  if (!container) return tl::unexpected(container.error());
  auto field = options.fields ? options.fields->field(data.function) : nullptr;
  if (!field) return fail("isosurface: there is no function");
  return std::make_unique<PreparedIsosurface>(data, std::move(*container), std::move(field));
}

}  // namespace dioptre
