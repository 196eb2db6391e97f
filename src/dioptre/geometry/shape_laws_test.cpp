// SPDX-License-Identifier: Apache-2.0
// What every primitive keeps, on random rays: see Shape for the contract.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "dioptre/geometry/shape_samples_test.h"
#include "dioptre/geometry/shapes.h"

namespace dioptre {
namespace {

class ShapeLaws : public testing::TestWithParam<ShapeSample> {
 protected:
  ShapePtr shape_ = prepare_with(sample_options(), GetParam().data).value();
  Bounds box_ = finite_part(shape_->bounds());
  double size_ = 0.5 * max_component(box_.extent());
  std::mt19937_64 random_{11};

  /// The bounds themselves, or what is near the origin of infinite ones.
  static Bounds finite_part(const Bounds& b) {
    return b.finite() ? b : intersect(b, {{-4, -4, -4}, {4, 4, 4}});
  }

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vec3 point(double reach) {
    const double x = uniform(-reach, reach), y = uniform(-reach, reach);
    return box_.center() + size_ * Vec3{x, y, uniform(-reach, reach)};
  }
  /// A ray at the shape, from near it, of any direction length.
  Ray ray() {
    const Vec3 from = point(2.5), to = point(0.8);
    return {from, std::exp(uniform(-5, 5)) * (to - from)};
  }
  Crossings crossings(const Ray& r, Interval range = Interval::all()) {
    Crossings out;
    shape_->crossings(r, range, out);
    return out;
  }
  /// The sine of the angle between ray and surface.
  static double steepness(const Ray& r, Vec3 normal) {
    return std::fabs(dot(r.direction, normal)) / length(r.direction);
  }
};

TEST_P(ShapeLaws, CrossingsAreOrderedAndAlternate) {
  int found = 0;
  for (int i = 0; i < 3000; ++i) {
    const Ray r = ray();
    Crossings out;
    bool inside = shape_->crossings(r, Interval::all(), out);
    double last = -kInfinity;
    for (const Crossing& c : out) {
      ASSERT_GE(c.t, last);
      ASSERT_TRUE(std::isfinite(c.t) && c.error >= 0 && std::isfinite(c.error));
      if (shape_->solid()) {
        ASSERT_NE(c.entering, inside);
        inside = c.entering;
      }
      last = c.t;
      ++found;
    }
  }
  EXPECT_GT(found, 10);
}

TEST_P(ShapeLaws, SpansAgreeWithContains) {
  for (int i = 0; i < 3000; ++i) {
    const Ray r = ray();
    Crossings out;
    bool inside = shape_->crossings(r, {0, kInfinity}, out);
    Crossing end;
    end.t = 1e3 * size_ / length(r.direction);
    out.push_back(end);
    double last = 0, last_error = 1e-12 / length(r.direction);
    for (const Crossing& c : out) {
      const double width = c.t - last;
      if (width > 1e-6 * size_ / length(r.direction) + 4 * (c.error + last_error)) {
        const Vec3 p = r.at(last + 0.5 * width);
        ASSERT_EQ(shape_->contains(p), shape_->solid() && inside)
            << p.x << " " << p.y << " " << p.z << " t " << last << " to " << c.t;
      }
      if (shape_->solid()) inside = c.entering;
      last = c.t, last_error = c.error;
    }
  }
}

TEST_P(ShapeLaws, ErrorsAreSmallAndBoundTheSurface) {
  for (int i = 0; i < 3000; ++i) {
    const Ray r = ray();
    const Crossings out = crossings(r);
    const double unit = size_ / length(r.direction);
    for (std::size_t k = 0; k < out.size(); ++k) {
      const Crossing& c = out[k];
      const double before = k > 0 ? c.t - out[k - 1].t : kInfinity;
      const double after = k + 1 < out.size() ? out[k + 1].t - c.t : kInfinity;
      if (std::min(before, after) < 1e-3 * unit || std::fabs(c.t) > 100 * unit) continue;
      if (steepness(r, shape_->surface(r, c).normal) < 0.1) continue;
      EXPECT_LT(c.error, 1e-7 * unit);
      if (!shape_->solid()) continue;
      const double step = 2 * c.error + 1e-13 * unit;
      EXPECT_EQ(shape_->contains(r.at(c.t + step)), c.entering);
      EXPECT_EQ(shape_->contains(r.at(c.t - step)), !c.entering);
    }
  }
}

TEST_P(ShapeLaws, NormalsAreUnitAndPointOut) {
  for (int i = 0; i < 3000; ++i) {
    const Ray r = ray();
    for (const Crossing& c : crossings(r)) {
      const Surface s = shape_->surface(r, c);
      ASSERT_NEAR(length(s.normal), 1, 1e-12);
      ASSERT_NEAR(length(s.shading_normal), 1, 1e-9);
      const Vec2 uv = shape_->uv(r, c);
      ASSERT_TRUE(std::isfinite(uv.x) && std::isfinite(uv.y));
      if (steepness(r, s.normal) < 1e-4) continue;
      ASSERT_EQ(dot(r.direction, s.normal) < 0, c.entering) << c.t << " face " << c.face;
    }
  }
}

TEST_P(ShapeLaws, BoundsHoldWhatIsInsideAndOnTheSurface) {
  const Bounds b = shape_->bounds();
  const Vec3 slack = 1e-9 * size_ * Vec3{1, 1, 1};
  const Bounds wide{b.min - slack, b.max + slack};
  for (int i = 0; i < 3000; ++i) {
    const Ray r = ray();
    for (const Crossing& c : crossings(r)) {
      if (std::fabs(c.t) * length(r.direction) > 1e4 * size_ || !c.visible) continue;
      EXPECT_TRUE(wide.contains(shape_->surface(r, c).position));
    }
    const Vec3 p = point(3);
    EXPECT_TRUE(!shape_->contains(p) || wide.contains(p));
  }
}

TEST_P(ShapeLaws, NearestIsTheFirstVisibleCrossing) {
  for (int i = 0; i < 3000; ++i) {
    const Ray r = ray();
    const double a = uniform(-1, 2) / length(r.direction), b = uniform(0, 9) / length(r.direction);
    const Interval range{i % 3 ? 0 : a, i % 2 ? kInfinity : b};
    const Crossing* first = nullptr;
    const Crossings out = crossings(r, range);
    for (const Crossing& c : out) {
      if (!first && c.visible) first = &c;
    }
    Crossing nearest;
    ASSERT_EQ(shape_->nearest(r, range, nearest), first != nullptr);
    if (!first) continue;
    EXPECT_LE(std::fabs(nearest.t - first->t), nearest.error + first->error);
    EXPECT_EQ(nearest.entering, first->entering);
    EXPECT_TRUE(range.surrounds(nearest.t) && nearest.visible);
  }
}

TEST_P(ShapeLaws, ARangeCutsTheCrossings) {
  for (int i = 0; i < 2000; ++i) {
    const Ray r = ray();
    Crossings all, part;
    bool inside = shape_->crossings(r, Interval::all(), all);
    const double low = uniform(-1, 2) / length(r.direction);
    const Interval range{low, low + uniform(0, 4) / length(r.direction)};
    const bool inside_there = shape_->crossings(r, range, part);
    std::size_t next = 0;
    bool near_end = false;
    for (const Crossing& c : all) {
      near_end |= std::fabs(c.t - range.min) <= 4 * c.error;
      near_end |= std::fabs(c.t - range.max) <= 4 * c.error;
    }
    if (near_end) continue;
    for (const Crossing& c : all) {
      if (c.t <= range.min) inside = c.entering;
      if (!range.surrounds(c.t)) continue;
      ASSERT_LT(next, part.size());
      EXPECT_EQ(part[next].t, c.t) << "the range asked must not show in the bits";
      EXPECT_EQ(part[next++].entering, c.entering);
    }
    EXPECT_EQ(next, part.size());
    EXPECT_TRUE(!shape_->solid() || inside_there == inside);
  }
}

TEST_P(ShapeLaws, TheDirectionsLengthScalesT) {
  for (int i = 0; i < 1000; ++i) {
    const Ray r = ray();
    const Crossings out = crossings(r);
    for (const double factor : {0x1p-20, 0x1p33}) {
      const Crossings scaled = crossings({r.origin, factor * r.direction});
      ASSERT_EQ(scaled.size(), out.size());
      for (std::size_t k = 0; k < out.size(); ++k) {
        EXPECT_LE(std::fabs(scaled[k].t * factor - out[k].t),
                  2 * (out[k].error + scaled[k].error * factor));
        EXPECT_EQ(scaled[k].entering, out[k].entering);
      }
    }
  }
}

TEST_P(ShapeLaws, ALeavingRayDoesNotMeetItsOwnSurface) {
  if (!GetParam().convex) return;
  for (int i = 0; i < 4000; ++i) {
    const Ray r = ray();
    for (const Crossing& c : crossings(r)) {
      if (!c.visible) continue;
      const Surface s = shape_->surface(r, c);
      const double offset =
          8 * (c.error * length(r.direction) + 0x1p-52 * max_component(abs(s.position)));
      Vec3 away = normalize(Vec3{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)});
      if (dot(away, s.normal) < 0) away = -away;
      Crossing again;
      EXPECT_FALSE(shape_->nearest({s.position + offset * s.normal, away}, {0, kInfinity}, again))
          << "error " << c.error << " t " << again.t << " face " << c.face;
    }
  }
}

TEST_P(ShapeLaws, OddRaysAreHarmless) {
  const double values[] = {0,      std::nan(""), kInfinity, -kInfinity, 1e300,
                           -1e300, 1e-300,       5e-324,    1};
  Crossings out;
  Crossing first;
  for (const double a : values) {
    for (const double b : values) {
      for (const double c : values) {
        out.clear();
        for (const Ray& r : {Ray{{a, b, c}, {c, a, b}}, Ray{{0.1, 0.1, 0.1}, {a, b, c}},
                             Ray{{a, b, c}, {0, 0, 1}}}) {
          shape_->crossings(r, Interval::all(), out);
          shape_->crossings(r, {0, kInfinity}, out);
          shape_->crossings(r, {a, c}, out);
          shape_->nearest(r, {0, 10}, first);
        }
        shape_->contains({a, b, c});
        ASSERT_LT(out.size(), 2000u);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShapeLaws, testing::ValuesIn(shape_samples()),
                         [](const auto& info) { return info.param.name; });

TEST(ShapeSamples, HoldEveryPrimitive) {
  std::vector<bool> seen(std::variant_size_v<ShapeData>);
  for (const ShapeSample& sample : shape_samples()) seen[sample.data.index()] = true;
  for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_TRUE(seen[i]) << "alternative " << i;
}

}  // namespace
}  // namespace dioptre
