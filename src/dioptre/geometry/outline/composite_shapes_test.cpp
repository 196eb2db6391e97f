// SPDX-License-Identifier: Apache-2.0
// Laws of the solids made of many pieces, on random rays.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "dioptre/geometry/blob/blob.h"
#include "dioptre/geometry/mesh/mesh.h"
#include "dioptre/geometry/prism/prism.h"
#include "dioptre/geometry/text/text.h"

namespace dioptre {
namespace {

struct Case {
  std::string name;
  std::variant<Prism, Blob, Text, Mesh> data;
};

/// From the package fonts-dejavu-core.
std::string font() { return "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"; }

Prism prism_of(OutlineSpline spline, bool conic) {
  Prism p;
  p.spline = spline;
  p.conic = conic;
  p.height1 = conic ? -1 : 0.5;
  p.height2 = conic ? 1.5 : -1;
  switch (spline) {
    case OutlineSpline::kLinear:
      p.outlines = {{{1, 1}, {-1, 1}, {-1, -1}, {0.5, -1}, {0, 0}},
                    {{-0.5, 0.5}, {0, 0.8}, {0.1, 0.4}}};
      break;
    case OutlineSpline::kQuadratic:
      p.outlines = {{{0.3, -1.2}, {1, -1}, {1.4, 1}, {-1, 1.2}, {-1, -1}, {1, -1}}};
      break;
    case OutlineSpline::kCubic:
      p.outlines = {
          {{0.3, -1.2}, {1, -1}, {1.4, 1}, {0, 0.3}, {-1, 1.2}, {-1, -1}, {1, -1}, {2, 2}}};
      break;
    case OutlineSpline::kBezier:
      p.outlines = {{{0, 0}, {0, 1}, {1, 2}, {2, 2}, {2, 2}, {3, 1}, {2, 0}, {0, 0}}};
      break;
  }
  return p;
}

Blob lumps() {
  Blob b;
  b.threshold = 0.3;
  BlobComponent ball, rod, dent;
  rod.cylinder = true;
  rod.b = {2, 0, 0};
  rod.radius = 0.5;
  dent.a = {0, 2, 0};
  dent.radius = 1.5;
  dent.strength = -0.3;
  dent.transform = then(scaling({1, 1.2, 0.7}), rotation({20, 30, 40}));
  b.components = {ball, rod, dent};
  return b;
}

Mesh cube() {
  MeshData data;
  for (int i = 0; i < 8; ++i) {
    data.corners.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  }
  const std::uint32_t quads[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                     {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
  for (const auto& q : quads) {
    MeshData::Face f, g;
    f.corners = {q[0], q[1], q[2]};
    g.corners = {q[0], q[2], q[3]};
    data.faces.push_back(f);
    data.faces.push_back(g);
  }
  Mesh mesh;
  mesh.data = data;
  mesh.inside_vector = {0.3, 1, 0.2};
  return mesh;
}

std::vector<Case> cases() {
  std::vector<Case> all;
  const char* names[] = {"Linear", "Quadratic", "Cubic", "Bezier"};
  for (int i = 0; i < 4; ++i) {
    for (bool conic : {false, true}) {
      all.push_back({std::string(names[i]) + (conic ? "Conic" : "") + "Prism",
                     prism_of(static_cast<OutlineSpline>(i), conic)});
    }
  }
  all.push_back({"Blob", lumps()});
  Text text;
  text.font = font();
  text.text = "Ag&8";
  text.thickness = 0.5;
  all.push_back({"Text", text});
  text.offset = {-0.3, 0.05, 0.1};
  all.push_back({"OverlappingText", text});
  all.push_back({"Mesh", cube()});
  return all;
}

class CompositeShape : public testing::TestWithParam<Case> {
 protected:
  ShapePtr shape_ = std::visit([](const auto& d) { return prepare(d); }, GetParam().data).value();
  std::mt19937 random_{7};

  Vec3 point(double reach) {
    std::uniform_real_distribution<double> u(-reach, reach);
    const Bounds b = shape_->bounds();
    const double size = 0.5 * max_component(b.extent());
    const double x = u(random_), y = u(random_), z = u(random_);
    return b.center() + size * Vec3{x, y, z};
  }
  Ray ray() {
    const Vec3 a = point(1.8), b = point(0.9);
    return {a, std::exp(std::uniform_real_distribution<double>(-6, 6)(random_)) * (b - a)};
  }
};

TEST_P(CompositeShape, CrossingsAlternateInOrderAndEndOutside) {
  for (int i = 0; i < 4000; ++i) {
    const Ray r = ray();
    Crossings out;
    EXPECT_FALSE(shape_->crossings(r, Interval::all(), out));
    bool inside = false;
    double last = -kInfinity;
    for (const Crossing& c : out) {
      EXPECT_GE(c.t, last);
      EXPECT_NE(c.entering, inside);
      EXPECT_TRUE(c.error >= 0 && c.error < kInfinity);
      last = c.t;
      inside = c.entering;
    }
    EXPECT_FALSE(inside);
  }
}

TEST_P(CompositeShape, SpansAgreeWithContains) {
  int spans = 0;
  for (int i = 0; i < 4000; ++i) {
    const Ray r = ray();
    Crossings out;
    shape_->crossings(r, Interval::all(), out);
    for (std::size_t k = 0; k + 1 < out.size(); ++k) {
      const double width = out[k + 1].t - out[k].t;
      if (width < 1e-9 * std::fabs(out[k].t) + 4 * (out[k].error + out[k + 1].error)) continue;
      const Vec3 p = r.at(0.5 * (out[k].t + out[k + 1].t));
      EXPECT_EQ(shape_->contains(p), out[k].entering) << p.x << " " << p.y << " " << p.z;
      ++spans;
    }
  }
  EXPECT_GT(spans, 500);
}

TEST_P(CompositeShape, ErrorBoundsTheDistanceToTheSurface) {
  for (int i = 0; i < 4000; ++i) {
    const Ray r = ray();
    Crossings out;
    shape_->crossings(r, Interval::all(), out);
    for (const Crossing& c : out) {
      const double slack = 1e-12 * std::fabs(c.t);
      bool alone = true;  // nothing else nearby
      for (const Crossing& other : out) {
        alone &= &other == &c || std::fabs(other.t - c.t) > 8 * (c.error + other.error + slack);
      }
      if (!alone) continue;
      EXPECT_LT(c.error, 1e-4 / length(r.direction));
      EXPECT_EQ(shape_->contains(r.at(c.t + 2 * (c.error + slack))), c.entering);
      EXPECT_EQ(shape_->contains(r.at(c.t - 2 * (c.error + slack))), !c.entering);
    }
  }
}

TEST_P(CompositeShape, RangesCutTheSameCrossings) {
  for (int i = 0; i < 2000; ++i) {
    const Ray r = ray();
    Crossings all, part;
    shape_->crossings(r, Interval::all(), all);
    std::uniform_real_distribution<double> u(-0.5, 2);
    double low = u(random_) / length(r.direction), high = u(random_) / length(r.direction);
    if (low > high) std::swap(low, high);
    const bool inside = shape_->crossings(r, {low, high}, part);
    std::vector<Crossing> expected;
    bool expected_inside = false;
    for (const Crossing& c : all) {
      if (c.t <= low) expected_inside = c.entering;
      if (c.t > low && c.t < high) expected.push_back(c);
    }
    EXPECT_EQ(inside, expected_inside);
    ASSERT_EQ(part.size(), expected.size());
    for (std::size_t k = 0; k < part.size(); ++k) {
      EXPECT_NEAR(part[k].t, expected[k].t, part[k].error + expected[k].error);
      EXPECT_EQ(part[k].entering, expected[k].entering);
    }
    Crossing first;
    EXPECT_EQ(shape_->nearest(r, {low, high}, first), !part.empty());
    if (!part.empty()) {
      EXPECT_EQ(first.t, part[0].t);
      EXPECT_EQ(first.entering, part[0].entering);
    }
  }
}

TEST_P(CompositeShape, NormalsPointOutAndPositionsLieOnTheRay) {
  for (int i = 0; i < 2000; ++i) {
    const Ray r = ray();
    Crossings out;
    shape_->crossings(r, Interval::all(), out);
    for (const Crossing& c : out) {
      const Surface s = shape_->surface(r, c);
      EXPECT_NEAR(length(s.normal), 1, 1e-12);
      EXPECT_TRUE(shape_->bounds().contains(s.position) || GetParam().name == "Blob");
      const double along = dot(s.normal, r.direction) / length(r.direction);
      if (std::fabs(along) > 1e-4) {
        EXPECT_EQ(along < 0, c.entering);
        EXPECT_NEAR(length(s.position - r.at(c.t)), 0, 1e-9);
      }
    }
  }
}

TEST_P(CompositeShape, DirectionsWithoutLengthOrNumberAreHarmless) {
  const double nan = std::nan("");
  const double values[] = {0, nan, kInfinity, -kInfinity, 1e300, 1e-300, 1};
  Crossings out;
  Crossing first;
  for (double a : values) {
    for (double b : values) {
      for (double c : values) {
        out.clear();
        shape_->crossings({{a, b, c}, {c, a, b}}, {0, kInfinity}, out);
        shape_->crossings({{0.1, 0.1, 0.1}, {a, b, c}}, Interval::all(), out);
        shape_->nearest({{a, b, c}, {1, 0, 0}}, {0, 10}, first);
        shape_->contains({a, b, c});
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, CompositeShape, testing::ValuesIn(cases()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace dioptre
