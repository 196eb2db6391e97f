// SPDX-License-Identifier: Apache-2.0
// Rays whose crossings are known exactly.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "dioptre/geometry/shapes.h"

namespace dioptre {
namespace {

Crossings all_crossings(const Shape& shape, const Ray& ray, Interval range = Interval::all()) {
  Crossings out;
  shape.crossings(ray, range, out);
  return out;
}

ShapePtr make(const ShapeData& data) { return prepare(data).value(); }

void expect_crossings(const Shape& shape, const Ray& ray, const std::vector<double>& t,
                      double tolerance) {
  const Crossings found = all_crossings(shape, ray);
  ASSERT_EQ(found.size(), t.size());
  for (std::size_t i = 0; i < t.size(); ++i) EXPECT_NEAR(found[i].t, t[i], tolerance);
}

TEST(Sphere, IsHitExactlyFromAnyDistance) {
  const ShapePtr sphere = make(Sphere{});
  for (int k = 1; k <= 12; ++k) {
    const double far = std::pow(10, k);
    const Ray ray{{0, 0, -far}, {0, 0, 1}};
    Crossing c;
    ASSERT_TRUE(sphere->nearest(ray, {0, kInfinity}, c));
    EXPECT_NEAR(c.t, far - 1, 4e-16 * far);
    EXPECT_EQ(sphere->surface(ray, c).normal, (Vec3{0, 0, -1}));
  }
}

TEST(Sphere, IsHitNearItsRimFromAnyDistance) {
  const ShapePtr sphere = make(Sphere{});
  const double depth = std::sqrt((1 - 0.999999) * (1 + 0.999999));
  for (int k = 1; k <= 12; ++k) {
    const double far = std::pow(10, k);
    Crossing c;
    ASSERT_TRUE(sphere->nearest({{0.999999, 0, -far}, {0, 0, 1}}, {0, kInfinity}, c));
    EXPECT_NEAR(c.t, far - depth, 1e-15 * far + 1e-13);
  }
}

TEST(Sphere, GrazingChordsHaveTheirLength) {
  const ShapePtr sphere = make(Sphere{});
  const struct {
    double offset, chord, relative;
  } cases[] = {{1 - 1e-6, 0.0028284264176393, 1e-10},
               {1 - 1e-9, 8.9442719077631e-5, 1e-7},
               {1 - 1e-12, 2.828427124745e-6, 1e-4}};
  for (const auto& c : cases) {
    const Crossings found = all_crossings(*sphere, {{c.offset, 0, -10}, {0, 0, 1}});
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NEAR((found[1].t - found[0].t) / c.chord, 1, c.relative);
  }
  EXPECT_TRUE(all_crossings(*sphere, {{1 + 1e-9, 0, -10}, {0, 0, 1}}).empty());
}

TEST(Sphere, ThinShellsHaveTwoWalls) {
  const ShapePtr outer = make(Sphere{});
  for (int k = 2; k <= 12; ++k) {
    const double e = std::pow(10, -k);
    const Ray ray{{0, 0, -5}, {0, 0, 1}};
    const Crossings a = all_crossings(*outer, ray);
    const Crossings b = all_crossings(*make(Sphere{{}, 1 - e}), ray);
    ASSERT_EQ(a.size() + b.size(), 4u);
    const double solid = (b[0].t - a[0].t) + (a[1].t - b[1].t);
    EXPECT_NEAR(solid / (2 * e), 1, k == 12 ? 1e-3 : 1e-4);
  }
}

TEST(Torus, IsHitFromAnyDistance) {
  const ShapePtr torus = make(Torus{1, 0.25});
  for (int k = 0; k <= 12; ++k) {
    const double far = std::pow(10, k) + 1.25;
    expect_crossings(*torus, {{-far, 0, 0}, {1, 0, 0}},
                     {far - 1.25, far - 0.75, far + 0.75, far + 1.25}, 4e-16 * far + 1e-15);
  }
}

TEST(Torus, ChordsHaveTheirWidth) {
  const ShapePtr torus = make(Torus{1, 0.25});
  const auto half_widths = [&](double y) {
    const Crossings c = all_crossings(*torus, {{-5, y, 0}, {1, 0, 0}});
    EXPECT_EQ(c.size(), 4u);
    return c.size() == 4 ? 0.5 * (c[1].t - c[0].t) : 0;
  };
  EXPECT_NEAR(half_widths(0.2), 0.15, 1e-14);
  EXPECT_NEAR(half_widths(0.249999), 7.0710607407941e-4, 1e-10);
  EXPECT_TRUE(all_crossings(*torus, {{0, 5, 0}, {0, -1, 0}}).empty());
  expect_crossings(*torus, {{1, 5, 0}, {0, -1, 0}}, {4.75, 5.25}, 1e-14);
}

TEST(Torus, ThinOnesAreHitWhereTheyAre) {
  for (const double r : {1e-3, 1e-4, 1e-5}) {
    Crossing c;
    ASSERT_TRUE(make(Torus{1, r})->nearest({{-10, 0, 0}, {1, 0, 0}}, {0, kInfinity}, c));
    EXPECT_NEAR(c.t, 10 - 1 - r, 1e-14);
  }
}

TEST(Torus, ASpindleIsFilled) {
  const ShapePtr spindle = make(Torus{0.5, 1});
  const double tip = std::sqrt(0.75);
  expect_crossings(*spindle, {{0, 5, 0}, {0, -1, 0}}, {5 - tip, 5 + tip}, 1e-7);
  expect_crossings(*spindle, {{-5, 0, 0}, {1, 0, 0}}, {3.5, 6.5}, 1e-14);
  EXPECT_TRUE(spindle->contains({0, 0.5, 0}));
  EXPECT_FALSE(spindle->contains({0, 0.9, 0}));
}

/// The solids as sized by a factor.
std::vector<ShapeData> sized(double s) {
  return {Sphere{{0, 0, 0}, s},
          Box{{-s, -s, -s}, {s, s, s}},
          Plane{{0, 0, -1}, s},
          Cylinder{{0, -s, 0}, {0, s, 0}, s},
          Cone{{0, -s, 0}, s, {0, s, 0}, 0},
          Torus{s, 0.25 * s},
          Disc{{0, 0, -s}, {0, 0, 1}, s},
          Quadric{{1 / (s * s), 1 / (s * s), 1 / (s * s)}, {}, {}, -1},
          Poly{2, {1 / (s * s), 0, 0, 0, 1 / (s * s), 0, 0, 1 / (s * s), 0, -1}, false}};
}

TEST(Primitives, AnySizeGivesTheSamePicture) {
  const std::vector<ShapeData> unit = sized(1);
  const Vec3 from{0.1, 0.2, -10}, towards{0.01, -0.02, 1};
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const Crossings expected = all_crossings(*make(unit[i]), {from, towards});
    ASSERT_FALSE(expected.empty()) << i;
    for (int k = -12; k <= 12; ++k) {
      const double s = std::pow(10, k);
      const Crossings found = all_crossings(*make(sized(s)[i]), {s * from, towards});
      ASSERT_EQ(found.size(), expected.size()) << i << " at 10^" << k;
      for (std::size_t n = 0; n < found.size(); ++n) {
        EXPECT_NEAR(found[n].t / s, expected[n].t, 1e-12 * std::fabs(expected[n].t)) << i;
      }
    }
  }
}

TEST(Box, IsLeftFromWithin) {
  const ShapePtr box = make(Box{{1, 1, 1}, {-1, -1, -1}});
  const Ray ray{{0, 0, 0}, {0, 0, 1}};
  Crossings out;
  EXPECT_TRUE(box->crossings(ray, {0, kInfinity}, out));
  ASSERT_EQ(out.size(), 1u);
  EXPECT_EQ(out[0].t, 1);
  EXPECT_FALSE(out[0].entering);
}

TEST(Box, WithoutThicknessIsDrawn) {
  const ShapePtr flat = make(Box{{-1, -1, -1}, {1, 1, -1}});
  Crossing c;
  const Ray ray{{0.2, 0.3, -5}, {0, 0, 1}};
  ASSERT_TRUE(flat->nearest(ray, {0, kInfinity}, c));
  EXPECT_EQ(c.t, 4);
  EXPECT_EQ(flat->surface(ray, c).normal, (Vec3{0, 0, -1}));
}

TEST(Primitives, RaysThatStartOnTheSurfaceMeetOnlyTheFarSide) {
  const struct {
    ShapeData data;
    Vec3 start;
    double far;
  } cases[] = {{Sphere{}, {0, 0, -1}, 2},
               {Box{{-1, -1, -1}, {1, 1, 1}}, {0, 0, -1}, 2},
               {Cylinder{{0, -1, 0}, {0, 1, 0}, 1}, {0, 0, -1}, 2},
               {Cone{{0, -1, 0}, 1, {0, 1, 0}, 0}, {0, 0, -0.5}, 1},
               {Torus{1, 0.25}, {0, 0, -1.25}, 0.5}};
  for (const auto& c : cases) {
    const ShapePtr shape = make(c.data);
    const std::size_t i = c.data.index();
    Crossing hit;
    ASSERT_TRUE(shape->nearest({c.start, {0, 0, 1}}, {1e-12, kInfinity}, hit)) << i;
    EXPECT_NEAR(hit.t, c.far, 1e-14) << i;
    EXPECT_FALSE(shape->nearest({c.start, {0, 0, -1}}, {1e-12, kInfinity}, hit)) << i;
  }
}

TEST(Cone, RaysThroughApexAxisAndSideLineKeepParity) {
  const ShapePtr cone = make(Cone{{0, -1, 0}, 1, {0, 1, 0}, 0});
  expect_crossings(*cone, {{0, 5, 0}, {0, -1, 0}}, {4, 6}, 1e-14);
  const ShapePtr cylinder = make(Cylinder{{0, -1, 0}, {0, 1, 0}, 1});
  expect_crossings(*cylinder, {{0, 5, 0}, {0, -1, 0}}, {4, 6}, 1e-14);
  const Ray odd[] = {{{-5, 1, 0}, {1, 0, 0}},    // through the apex, across
                     {{-1, -1, 0}, {1, 2, 0}},   // along a side line
                     {{-5, 6, 0}, {1, -1, 0}},   // through the apex, down
                     {{-3, -5, 0}, {1, 2, 0}}};  // a side line from afar
  for (const Ray& ray : odd) {
    const Crossings c = all_crossings(*cone, ray);
    EXPECT_EQ(c.size() % 2, 0u);
    for (const Crossing& crossing : c) EXPECT_TRUE(std::isfinite(crossing.t));
  }
  EXPECT_EQ(all_crossings(*cylinder, {{1, 5, 0}, {0, -1, 0}}).size() % 2, 0u);
  const ShapePtr box = make(Box{{-1, -1, -1}, {1, 1, 1}});
  for (const Ray& ray :
       {Ray{{-2, 0, 0}, {1, 1, 0}}, Ray{{1, 1, -5}, {0, 0, 1}}, Ray{{-2, -2, -2}, {1, 1, 1}}}) {
    EXPECT_EQ(all_crossings(*box, ray).size() % 2, 0u);
  }
}

TEST(Cylinder, OpenEndsBoundButAreNotDrawn) {
  const ShapePtr open = make(Cylinder{{0, 0, 0}, {0, 1, 0}, 1, true});
  const Ray down{{0, 5, 0}, {0, -1, 0}};
  EXPECT_EQ(all_crossings(*open, down).size(), 2u);
  Crossing c;
  EXPECT_FALSE(open->nearest(down, Interval::all(), c));
  EXPECT_TRUE(open->contains({0, 0.5, 0}));
}

TEST(Primitives, ASphereIsASphereHoweverItIsSaid) {
  const ShapePtr sphere = make(Sphere{});
  const ShapePtr quadric = make(Quadric{});
  Poly fourth;  // (x^2 + y^2 + z^2)^2 - 1
  fourth.order = 4;
  const auto place = [](int a, int b, int c) {
    int index = 0;
    for (int i = 4; i >= 0; --i)
      for (int j = 4 - i; j >= 0; --j)
        for (int k = 4 - i - j; k >= 0; --k, ++index)
          if (i == a && j == b && k == c) return index;
    return index;
  };
  fourth.coefficients.assign(35, 0);
  for (const auto& [a, b, c] : {std::array{4, 0, 0}, {0, 4, 0}, {0, 0, 4}})
    fourth.coefficients[place(a, b, c)] = 1;
  for (const auto& [a, b, c] : {std::array{2, 2, 0}, {2, 0, 2}, {0, 2, 2}})
    fourth.coefficients[place(a, b, c)] = 2;
  fourth.coefficients[34] = -1;
  const ShapePtr poly = make(fourth);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> u(-1.2, 1.2);
  for (int i = 0; i < 5000; ++i) {
    const double x = u(random), y = u(random);
    const Ray ray{{x, y, -4}, {0.1, 0.05, 1}};
    Crossing a, b, c;
    const bool hit = sphere->nearest(ray, {0, kInfinity}, a);
    ASSERT_EQ(quadric->nearest(ray, {0, kInfinity}, b), hit);
    ASSERT_EQ(poly->nearest(ray, {0, kInfinity}, c), hit);
    if (!hit) continue;
    const Vec3 normal = sphere->surface(ray, a).normal;
    EXPECT_LT(length(quadric->surface(ray, b).normal - normal), 1e-6);
    EXPECT_LT(length(poly->surface(ray, c).normal - normal), 1e-6);
  }
}

/// A solid's implicit function in extended precision, negative inside.
using Implicit = long double (*)(long double x, long double y, long double z);

TEST(Primitives, TheErrorHoldsTheTrueCrossing) {
  const struct {
    ShapeData data;
    Implicit f;
  } cases[] = {
      {Sphere{{1, 2, 3}, 2},
       [](long double x, long double y, long double z) {
         return (x - 1) * (x - 1) + (y - 2) * (y - 2) + (z - 3) * (z - 3) - 4;
       }},
      {Cylinder{{0, -1000, 0}, {0, 1000, 0}, 0.5},
       [](long double x, long double, long double z) { return x * x + z * z - 0.25L; }},
      {Cone{{0, -1, 0}, 1, {0, 1, 0}, 0},
       [](long double x, long double y, long double z) {
         return x * x + z * z - (1 - y) * (1 - y) / 4;
       }},
      {Torus{1, 0.25},
       [](long double x, long double y, long double z) {
         const long double off = std::sqrt(x * x + z * z) - 1;
         return off * off + y * y - 0.0625L;
       }},
      {Quadric{{2, 3, 4}, {1, -1, 0.5}, {0.25, 0, 0}, -1},
       [](long double x, long double y, long double z) {
         return 2 * x * x + 3 * y * y + 4 * z * z + x * y - x * z + y * z / 2 + x / 4 - 1;
       }},
      {Poly{2, {1, 0, 0, 0, 1, 0, 0, 1, 0, -1}, false},
       [](long double x, long double y, long double z) { return x * x + y * y + z * z - 1; }}};
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> u(-1, 1);
  for (const auto& c : cases) {
    const ShapePtr shape = make(c.data);
    const auto at = [&](const Ray& r, long double t) {
      return c.f(r.origin.x + t * r.direction.x, r.origin.y + t * r.direction.y,
                 r.origin.z + t * r.direction.z);
    };
    int checked = 0;
    for (int i = 0; i < 20000; ++i) {
      const double x = u(random), y = u(random), z = u(random);
      const Vec3 to{1.5 * x, 1.5 * y, 1.5 * z};
      const double far = std::exp(20 * u(random));
      const Ray r{to + far * Vec3{y, z, u(random)}, Vec3{u(random), u(random), u(random)}};
      const Vec3 aim = to - r.origin;
      for (const Crossing& hit : all_crossings(*shape, {r.origin, aim})) {
        if (hit.face != 0) continue;
        const Ray ray{r.origin, aim};
        const long double before = at(ray, hit.t - static_cast<long double>(hit.error));
        const long double after = at(ray, hit.t + static_cast<long double>(hit.error));
        // A chord shorter than its errors has both ends outside.
        const bool tangent = before > 0 && after > 0 && !(at(ray, hit.t) < -1e-9L);
        EXPECT_TRUE(before * after <= 0 || tangent)
            << c.data.index() << " t " << hit.t << " error " << hit.error << " far " << far;
        ++checked;
      }
    }
    EXPECT_GT(checked, 1000) << c.data.index();
  }
}

TEST(Quadric, BoundsAreFiniteWhereItEnds) {
  const auto bounds = [](const Quadric& q) { return make(q)->bounds(); };
  EXPECT_TRUE(bounds({{1, 4, 9}, {}, {1, 0, 0}, -1}).finite());
  EXPECT_TRUE(bounds({{2, 3, 4}, {1, -1, 0.5}, {0.25, 0, 0}, -1}).finite());
  const Bounds along_y = bounds({{1, 0, 1}, {}, {}, -1});
  EXPECT_TRUE(std::isfinite(along_y.min.x) && std::isfinite(along_y.max.z));
  EXPECT_EQ(along_y.max.y, kInfinity);
  const Bounds bowl = bounds({{1, 0, 1}, {}, {0, -1, 0}, 0});
  EXPECT_NEAR(bowl.min.y, 0, 1e-12);
  EXPECT_EQ(bowl.max.y, kInfinity);
  EXPECT_TRUE(bounds({{1, 1, 1}, {}, {}, 1}).empty());
}

/// As POV-Ray 3.7 renders them with uv_mapping.
TEST(Surface, CoordinatesAreThoseOfSceneFiles) {
  const auto uv = [](const ShapeData& data, const Ray& ray) {
    const ShapePtr shape = make(data);
    Crossing c;
    EXPECT_TRUE(shape->nearest(ray, {0, kInfinity}, c));
    return shape->uv(ray, c);
  };
  const auto expect = [](Vec2 found, Vec2 wanted) {
    EXPECT_NEAR(found.x, wanted.x, 1e-4);
    EXPECT_NEAR(found.y, wanted.y, 1e-4);
  };
  const double step = 2.0 / 9;
  expect(uv(Sphere{}, {{2 * step, 0, -5}, {0, 0, 1}}), {0.8233, 0.5});
  expect(uv(Sphere{}, {{0, 2 * step, -5}, {0, 0, 1}}), {0.75, 0.6466});
  expect(uv(Torus{1, 0.25}, {{0, 5, 4 * 2.5 / 9}, {0, -1, 0}}), {0.25, 0.6767});
  expect(uv(Torus{1, 0.25}, {{0, 5, -4 * 2.5 / 9}, {0, -1, 0}}), {0.75, 0.6767});
  expect(uv(Torus{1, 0.25}, {{-3 * 2.5 / 9, 5, 0}, {0, -1, 0}}), {0, 0.8661});
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  const double off = 4 * step;
  expect(uv(box, {{off, 0, -5}, {0, 0, 1}}), {0.7639, 0.5});
  expect(uv(box, {{off, 0, 5}, {0, 0, -1}}), {0.4861, 0.5});
  expect(uv(box, {{-5, off, off}, {1, 0, 0}}), {0.2361, 0.6482});
  expect(uv(box, {{5, 0, off}, {-1, 0, 0}}), {0.5139, 0.5});
  expect(uv(box, {{0, 5, off}, {0, -1, 0}}), {0.375, 0.6852});
  expect(uv(box, {{off, -5, -off}, {0, 1, 0}}), {0.4861, 0.0185});
}

TEST(Primitives, OnlyWhatHasNoMeaningIsRefused) {
  const double nan = std::nan("");
  const ShapeData refused[] = {
      Plane{{0, 0, 0}, 1},    Cylinder{{1, 1, 1}, {1, 1, 1}, 1}, Cone{{0, 0, 0}, 1, {0, 0, 0}, 0.5},
      Sphere{{0, nan, 0}, 1}, Box{{0, 0, 0}, {1, kInfinity, 1}}, Torus{nan, 1},
      Poly{36, {}, false},    Poly{1, {1, 1, 1, 1}, false},      Poly{2, {1, 2}, false}};
  for (const ShapeData& data : refused) EXPECT_FALSE(prepare(data).has_value()) << data.index();
  const ShapeData empty[] = {Sphere{{0, 0, 0}, 0},
                             Torus{0, 0},
                             Torus{1, 0},
                             Cylinder{{0, 0, 0}, {0, 1, 0}, 0},
                             Cone{{0, 0, 0}, 0, {0, 1, 0}, 0},
                             Disc{{0, 0, 0}, {0, 0, 0}, 1},
                             Disc{{0, 0, 0}, {0, 1, 0}, 0},
                             Disc{{0, 0, 0}, {0, 1, 0}, 1, 2}};
  for (const ShapeData& data : empty) {
    const Result<ShapePtr> shape = prepare(data);
    ASSERT_TRUE(shape.has_value()) << data.index();
    EXPECT_TRUE(all_crossings(**shape, {{0.3, 5, 0.1}, {0.01, -1, 0.02}}).empty());
  }
  EXPECT_TRUE(make(Sphere{{0, 0, 0}, -1})->contains({0, 0, 0.5}));
}

}  // namespace
}  // namespace dioptre
