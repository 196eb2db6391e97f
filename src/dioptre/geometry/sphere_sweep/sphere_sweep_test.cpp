// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/sphere_sweep/sphere_sweep.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dioptre {
namespace {

SphereSweep sweep(SphereSweepSpline spline) {
  return {spline,
          {{{-1, 0, 0}, 0.3},
           {{0, 0.2, 0}, 0.4},
           {{1, 1, 0.1}, 0.5},
           {{2, 0, 0.4}, 0.2},
           {{3, 1, 0}, 0.3}}};
}

struct Measured {
  double x, y;
  Vec3 normal;
};

void expect_seen_from_above(SphereSweepSpline spline, std::initializer_list<Measured> all) {
  const ShapePtr shape = prepare(sweep(spline)).value();
  for (const Measured& m : all) {
    const Ray ray{{m.x, 5, 0.1}, {0, -1, 0}};
    Crossing hit;
    ASSERT_TRUE(shape->nearest(ray, {0, kInfinity}, hit));
    const Surface s = shape->surface(ray, hit);
    EXPECT_NEAR(s.position.y, m.y, 1e-6);
    EXPECT_LT(length(s.normal - m.normal), 2e-6);
  }
}

// Reference values: the same sweeps in POV-Ray 3.7, by its trace() function.
TEST(SphereSweep, SurfacesAreThoseOfPovRay) {
  const auto across = [](double x, double y) { return std::sqrt(1 - x * x - y * y); };
  const auto measured = [&](double at, double y, double nx, double ny, double z_sign) {
    return Measured{at, y, {nx, ny, z_sign * across(nx, ny)}};
  };
  expect_seen_from_above(SphereSweepSpline::kLinear,
                         {measured(-0.5, 0.451066090, -0.283577282, 0.917886409, 1),
                          measured(1.5, 1.144974747, 0.847076360, 0.527414750, -1),
                          measured(3, 1.282842712, 0, 0.942809042, 1)});
  expect_seen_from_above(SphereSweepSpline::kBSpline,
                         {measured(0, 0.773425043, -0.565777756, 0.808607806, 1),
                          measured(1.5, 0.926828916, 0.580474456, 0.780158332, -1),
                          measured(2, 0.529042506, 0.165075726, 0.713551316, -1)});
  expect_seen_from_above(SphereSweepSpline::kCubic,
                         {measured(0, 0.781037350, -0.807283923, 0.563721766, 1),
                          measured(1, 1.502862273, 0.057324632, 0.998292546, 1)});
}

TEST(SphereSweep, ASweepOfOnePlaceIsASphere) {
  for (const SphereSweepSpline spline : {SphereSweepSpline::kLinear, SphereSweepSpline::kCubic}) {
    const SphereSweep still{spline, std::vector<SphereSweep::Sphere>(5, {{1, 2, 3}, 0.5})};
    const ShapePtr shape = prepare(still).value();
    Crossings out;
    shape->crossings({{1, 2, -5}, {0, 0, 1}}, {0, kInfinity}, out);
    ASSERT_EQ(out.size(), 2u);
    EXPECT_NEAR(out[0].t, 7.5, 1e-12);
    EXPECT_NEAR(out[1].t, 8.5, 1e-12);
  }
}

TEST(SphereSweep, AFlatPathIsSolidSeenFromItsNormal) {
  // Rays at right angles to the path's plane: both ends of a span lie on the same sphere.
  SphereSweep flat = sweep(SphereSweepSpline::kCubic);
  for (SphereSweep::Sphere& s : flat.spheres) s.center.z = 0;
  const ShapePtr shape = prepare(flat).value();
  for (int i = 0; i < 400; ++i) {
    const Ray ray{{0.01 * i - 1, 0.5 * std::sin(i) + 0.5, -5}, {0, 0, 1}};
    Crossings out;
    shape->crossings(ray, {0, kInfinity}, out);
    ASSERT_LE(out.size(), 2u);
    if (out.empty()) continue;
    EXPECT_NEAR(out[0].t + out[1].t, 10, 1e-12);
    const double step = 2 * out[0].error + 1e-12;
    EXPECT_TRUE(shape->contains(ray.at(out[0].t + step)));
    EXPECT_FALSE(shape->contains(ray.at(out[0].t - step)));
  }
}

TEST(SphereSweep, OddParametersGiveAnErrorOrAShape) {
  EXPECT_FALSE(prepare(SphereSweep{}));
  EXPECT_FALSE(prepare(SphereSweep{SphereSweepSpline::kLinear, {{{0, 0, 0}, 1}}}));
  EXPECT_FALSE(prepare(SphereSweep{SphereSweepSpline::kBSpline, {{}, {}, {}}}));
  EXPECT_FALSE(prepare(SphereSweep{SphereSweepSpline::kLinear, {{{0, 0, 0}, std::nan("")}, {}}}));
  EXPECT_FALSE(prepare(SphereSweep{SphereSweepSpline::kLinear, {{{0, 0, 0}, 1e300}, {}}}));
  for (const double radius : {0.0, -1.0, 1e-100, 1e100}) {
    const SphereSweep odd{
        SphereSweepSpline::kCubic,
        {{{0, 0, 0}, radius}, {{0, 0, 0}, radius}, {{1, 0, 0}, 0}, {{2, 1, 0}, 1}}};
    const Result<ShapePtr> shape = prepare(odd);
    ASSERT_TRUE(shape);
    Crossings out;
    (*shape)->crossings({{0.5, 0.1, -2}, {0, 0, 1}}, Interval::all(), out);
  }
}

}  // namespace
}  // namespace dioptre
