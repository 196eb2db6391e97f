// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/isosurface/isosurface.h"

#include <algorithm>
#include <cmath>

#include "dioptre/geometry/isosurface/line_search.h"
#include "dioptre/geometry/quadratic.h"

namespace dioptre {
namespace {

/// A part of a ray in the container, of s from 0 to 1.
struct Stretch {
  double begin = 0, end = 0;
  Vec3 origin, step;

  Stretch(const Ray& ray, double begin, double end)
      : begin(begin), end(end), origin(ray.at(begin)), step((end - begin) * ray.direction) {}

  double t(double s) const { return std::clamp(begin + s * (end - begin), begin, end); }
  double s(double t) const { return (t - begin) / (end - begin); }
  bool usable() const { return begin < end && is_finite(origin) && is_finite(step); }
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
    bool inside = false;
    walk(ray, range, inside, [&](const Crossing& crossing) {
      if (range.surrounds(crossing.t)) out.push_back(crossing);
      return true;
    });
    return inside;
  }

  bool nearest(const Ray& ray, Interval range, Crossing& out) const override {
    bool inside = false, found = false;
    walk(ray, range, inside, [&](const Crossing& crossing) {
      found = crossing.visible && range.surrounds(crossing.t);
      if (found) out = crossing;
      return !found;
    });
    return found;
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

  /// Calls visit(crossing) for all crossings in the range in order, perhaps for others too, until
  /// that returns false; `inside` becomes the state just behind range.min. What is behind the ray's
  /// origin is a stretch by itself (measured).
  template <class Visit>
  void walk(const Ray& ray, Interval range, bool& inside, Visit&& visit) const {
    thread_local Crossings of_container;
    of_container.clear();
    container_->crossings(ray, Interval::all(), of_container);
    if (of_container.size() < 2) return;
    const Crossing in = of_container.front(), out = of_container.back();
    const bool halves = in.t < 0 && out.t > 0;
    const double ends[] = {in.t, halves ? 0 : out.t, out.t};
    bool state = false, known = in.t > range.min;
    for (int part = 0; part < (halves ? 2 : 1); ++part) {
      if (!(ends[part] < range.max && ends[part + 1] > range.min)) continue;
      const Stretch stretch(ray, ends[part], ends[part + 1]);
      if (!stretch.usable()) return;
      const FieldLine line(*field_, threshold_, stretch.origin, stretch.step);
      const double size = length(stretch.step);
      // The accuracy of what is reported is in the ray's units: the world's (measured).
      LineSearch search(line, {steepest_ * size,
                               accuracy_ / size,
                               accuracy_ / (stretch.end - stretch.begin),
                               {stretch.s(range.min), stretch.s(range.max)}});
      if (known && search.first_inside() != state) {
        state = !state;
        if (!visit(part == 0 ? cap(in) : crossing_at(ray, stretch, 0, 0, state))) return;
      }
      SignChange change;
      bool more = search.next(change);
      if (!known) state = inside = search.began_inside();
      known = true;
      for (; more; more = search.next(change)) {
        state = change.inside;
        const Crossing crossing = crossing_at(ray, stretch, change.s, change.error, state);
        if (crossing.t <= range.min) inside = state;
        if (!visit(crossing)) return;
      }
      state = search.last_inside();
    }
    if (known && state) visit(cap(out));
  }

  Crossing cap(Crossing crossing) const {
    ++crossing.face;
    crossing.visible = !open_;
    return crossing;
  }

  static Crossing crossing_at(const Ray& ray, const Stretch& stretch, double s, double error_s,
                              bool entering) {
    const double t = stretch.t(s);
    const double error = error_s * (stretch.end - stretch.begin) + shift_error(ray, t) +
                         8 * kRounding * std::fabs(t);
    return {.t = t, .error = error, .entering = entering};
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
