// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/text/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "dioptre/geometry/outline/sweep.h"
#include "dioptre/geometry/text/glyphs.h"

namespace dioptre {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon() / 2;

/// A letter in its place. Its faces are numbered from first_face.
struct Letter {
  const Outline* outline = nullptr;
  Vec3 pen;
  Slab slab;  ///< in z, the pen's included
  Bounds bounds;
  std::uint32_t first_face = 0;
};

/// Joins the spans of letters that overlap: keeps where the ray enters the first or leaves the
/// last.
void join_spans(Crossings& out, std::size_t first) {
  std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
            [](const Crossing& a, const Crossing& b) {
              if (a.t != b.t) return a.t < b.t;
              return a.entering != b.entering ? a.entering : a.face < b.face;
            });
  int depth = 0;
  std::size_t kept = first;
  for (std::size_t i = first; i < out.size(); ++i) {
    const int before = depth;
    depth += out[i].entering ? 1 : -1;
    if (before == 0 || depth == 0) out[kept++] = out[i];
  }
  out.resize(kept);
}

class PreparedText final : public Shape {
 public:
  PreparedText(GlyphRun run, double thickness) : outlines_(std::move(run.outlines)) {
    letters_.reserve(run.glyphs.size());
    std::uint32_t face = 0;
    for (const PlacedGlyph& glyph : run.glyphs) {
      const Outline& outline = outlines_[glyph.outline];
      const double z = glyph.pen.z;
      const PlaneBounds& plane = outline.bounds();
      Letter letter{
          &outline, glyph.pen, {std::min(z, z + thickness), std::max(z, z + thickness)}, {}, face};
      letter.bounds = {{plane.min.x + glyph.pen.x, plane.min.y + glyph.pen.y, letter.slab.low},
                       {plane.max.x + glyph.pen.x, plane.max.y + glyph.pen.y, letter.slab.high}};
      face += kFirstSide + static_cast<std::uint32_t>(outline.curves().size());
      bounds_ = unite(bounds_, letter.bounds);
      letters_.push_back(letter);
    }
  }

  Bounds bounds() const override { return bounds_; }

  bool crossings(const Ray& ray, Interval range, Crossings& out) const override {
    const Interval near = clip(bounds_, ray, Interval::all());
    if (near.empty() || !std::isfinite(near.min)) return false;
    const std::size_t first = out.size();
    int met = 0;
    for (const Letter& letter : letters_) {
      if (clip(letter.bounds, ray, near).empty()) continue;
      const std::size_t before = out.size();
      cross_linear_sweep(*letter.outline, FillRule::kNonZero, letter.slab,
                         sweep_ray(ray, near.min, letter.pen), out);
      for (std::size_t i = before; i < out.size(); ++i) out[i].face += letter.first_face;
      met += out.size() > before;
    }
    if (met > 1) join_spans(out, first);
    return keep_range(out, first, range);
  }

  bool contains(Vec3 p) const override {
    return std::any_of(letters_.begin(), letters_.end(), [&](const Letter& letter) {
      return letter.bounds.contains(p) &&
             letter.outline->winding({p.x - letter.pen.x, p.y - letter.pen.y}) != 0;
    });
  }

  Surface surface(const Ray& ray, const Crossing& crossing) const override {
    const auto after = std::upper_bound(
        letters_.begin(), letters_.end(), crossing.face,
        [](std::uint32_t face, const Letter& letter) { return face < letter.first_face; });
    const Letter& letter = *(after - 1);
    const std::uint32_t face = crossing.face - letter.first_face;
    Surface s;
    s.position = ray.at(crossing.t);
    if (face < kFirstSide) {
      s.position.z = face == kLowCap ? letter.slab.low : letter.slab.high;
      s.normal = {0, 0, face == kLowCap ? -1.0 : 1.0};
    } else {
      const Curve& curve = letter.outline->curves()[face - kFirstSide];
      const Vec2 p = curve.at(crossing.u), tangent = curve.tangent(crossing.u);
      s.position.x = p.x + letter.pen.x;
      s.position.y = p.y + letter.pen.y;
      const double size = length(tangent);
      s.normal = size > 0 ? Vec3{tangent.y / size, -tangent.x / size, 0} : Vec3{0, 0, 1};
      if ((dot(s.normal, ray.direction) > 0) == crossing.entering) s.normal = -s.normal;
    }
    s.shading_normal = s.normal;
    return s;
  }

 private:
  static SweepRay sweep_ray(const Ray& ray, double shift, Vec3 pen) {
    const Vec3 o = ray.at(shift) - pen, d = ray.direction;
    const Vec3 size = abs(ray.origin) + std::fabs(shift) * abs(d) + abs(pen);
    return {{o.x, o.y}, {d.x, d.y}, o.z + pen.z, d.z, shift, 4 * kEpsilon * max_component(size)};
  }

  std::vector<Outline> outlines_;
  std::vector<Letter> letters_;
  Bounds bounds_;
};

}  // namespace

Result<ShapePtr> prepare(const Text& text) {
  if (!std::isfinite(text.thickness)) return fail("text thickness is not finite");
  if (!is_finite(text.offset)) return fail("text offset is not finite");
  Result<GlyphRun> run = load_glyphs(text);
  if (!run) return tl::unexpected<Error>(run.error());
  return std::make_unique<PreparedText>(std::move(*run), text.thickness);
}

}  // namespace dioptre
