// SPDX-License-Identifier: Apache-2.0
#include "dioptre/geometry/shape_samples_test.h"

#include <array>

#include "dioptre/core/expression_eval.h"

namespace dioptre {
namespace {

/// Each quadric's ten coefficients in the order of a scene file.
Quadric quadric(const std::array<double, 10>& c) {
  return {{c[0], c[1], c[2]}, {c[3], c[4], c[5]}, {c[6], c[7], c[8]}, c[9]};
}

/// The number of the term x^a y^b z^c in a Poly of some order.
std::size_t term(int order, int a, int b, int c) {
  std::size_t index = 0;
  for (int i = order; i >= 0; --i) {
    for (int j = order - i; j >= 0; --j) {
      for (int k = order - i - j; k >= 0; --k, ++index) {
        if (i == a && j == b && k == c) return index;
      }
    }
  }
  return index;
}

Poly poly(int order, const std::vector<std::array<double, 4>>& terms) {
  Poly p;
  p.order = static_cast<std::uint32_t>(order);
  p.coefficients.resize(term(order, -1, 0, 0));
  for (const auto& [c, a, b, e] : terms) {
    p.coefficients[term(order, static_cast<int>(a), static_cast<int>(b), static_cast<int>(e))] = c;
  }
  return p;
}

Mesh octahedron(Vec3 inside_vector) {
  MeshData data;
  data.corners = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const std::uint32_t x : {0u, 1u}) {
    for (const std::uint32_t y : {2u, 3u}) {
      for (const std::uint32_t z : {4u, 5u}) {
        MeshData::Face face;
        face.corners = {x, y, z};
        data.faces.push_back(face);
      }
    }
  }
  Mesh mesh;
  mesh.data = data;
  mesh.inside_vector = inside_vector;
  return mesh;
}

Prism prism(OutlineSpline spline, bool conic, std::vector<Vec2> outline) {
  Prism p;
  p.spline = spline;
  p.conic = conic;
  p.height1 = conic ? 0.5 : -1;
  p.height2 = 1;
  p.outlines = {std::move(outline)};
  return p;
}

Blob blob() {
  Blob b;
  b.threshold = 0.3;
  BlobComponent ball, rod;
  ball.radius = 1.2;
  rod.cylinder = true;
  rod.b = {2, 0.5, 0};
  rod.radius = 0.6;
  b.components = {ball, rod};
  return b;
}

/// Hills with a pit and, at a corner, land at 0.
HeightField height_field(double water_level, bool smooth) {
  HeightGrid grid;
  grid.width = 7;
  grid.depth = 5;
  for (int k = 0; k < 35; ++k)
    grid.heights.push_back(k == 0 ? 0 : static_cast<float>(k * 13 % 29) / 32);
  return {grid, water_level, smooth};
}

/// A curled sheet whose first row is one point.
BicubicPatch patch(double flatness) {
  BicubicPatch p{{}, 3, 2, flatness, {}};
  for (std::size_t i = 0; i < 16; ++i) {
    const double column = static_cast<double>(i % 4), row = static_cast<double>(i / 4);
    p.points[i] = {column * row / 4, row, 0.3 * static_cast<double>(i * 7 % 5) * row};
  }
  return p;
}

JuliaFractal julia(JuliaAlgebra algebra, JuliaFunction function, std::uint32_t iterations) {
  JuliaFractal j;
  j.parameter = {-0.083, 0.1, -0.63, -0.025};
  j.algebra = algebra;
  j.function = function;
  j.max_iteration = iterations;
  j.precision = 2000;  // so that no part is missed
  return j;
}

Text text() {
  Text t;
  t.font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
  t.text = "a8";
  t.thickness = 0.4;
  return t;
}

/// A field by one formula for numbers and for jets.
template <class Formula>
class FormulaField final : public ScalarField {
 public:
  double value(std::span<const double> a) const override { return Formula::of(a[0], a[1], a[2]); }
  IntervalJet range(std::span<const IntervalJet> a) const override {
    return Formula::of(a[0], a[1], a[2]);
  }
};

template <class T>
T apply(Step::Code code, const T& a, const T& b) {
  return evaluate_operator(code, a, b);
}
template <class T>
T sum_of_squares(const T& x, const T& y, const T& z) {
  constexpr auto kTimes = Step::Code::kMultiply, kPlus = Step::Code::kAdd;
  return apply(kPlus, apply(kPlus, apply(kTimes, x, x), apply(kTimes, y, y)), apply(kTimes, z, z));
}

struct BallFormula {
  template <class T>
  static T of(const T& x, const T& y, const T& z) {
    return apply(Step::Code::kSqrt, sum_of_squares(x, y, z), x);
  }
};
struct WavesFormula {
  template <class T>
  static T of(const T& x, const T& y, const T& z) {
    const T waves = apply(Step::Code::kSin, apply(Step::Code::kMultiply, x, z), x);
    return apply(Step::Code::kAdd, waves,
                 apply(Step::Code::kSin, apply(Step::Code::kAdd, y, y), y));
  }
};
struct UnknownFormula {
  static double of(double x, double y, double z) { return BallFormula::of(x, y, z); }
  static IntervalJet of(const IntervalJet&, const IntervalJet&, const IntervalJet&) {
    return IntervalJet::everything();
  }
};

class SampleFields final : public ScalarFields {
 public:
  std::unique_ptr<const ScalarField> field(Id<Function> function) const override {
    switch (function.index) {
      case 0:
        return std::make_unique<FormulaField<BallFormula>>();
      case 1:
        return std::make_unique<FormulaField<WavesFormula>>();
      case 2:
        return std::make_unique<FormulaField<UnknownFormula>>();
      default:
        return nullptr;
    }
  }
};

Isosurface isosurface(std::uint32_t function, double threshold, double size) {
  Isosurface iso;
  iso.function = {function};
  iso.threshold = threshold;
  iso.accuracy = 1e-11;
  iso.container = {false, {-size, -size, -size}, {size, size, size}, {}, 0};
  return iso;
}

void add_isosurfaces(std::vector<ShapeSample>& all) {
  all.push_back({"IsosurfaceBall", isosurface(0, 0.9, 1), true});
  all.push_back({"CappedIsosurface", isosurface(0, 1.2, 1), true});
  all.push_back({"IsosurfaceOfWaves", isosurface(1, 0.3, 3)});
  all.push_back({"IsosurfaceWithoutBounds", isosurface(2, 0.9, 1)});
  Isosurface open = isosurface(1, 0.3, 3);
  open.container = {true, {}, {}, {0.5, 0, 0}, 3};
  open.open = true;
  all.push_back({"OpenIsosurface", open});
}

void add_convex(std::vector<ShapeSample>& all) {
  const auto add = [&](const char* name, ShapeData data) { all.push_back({name, data, true}); };
  add("UnitSphere", Sphere{});
  add("FarSphere", Sphere{{1000, -2000, 500}, 0.01});
  add("HugeSphere", Sphere{{1, 2, 3}, 1e9});
  add("Box", Box{{1, -2, 3}, {-1, 0.5, 3.25}});
  add("ThinBox", Box{{-1, 0, -1}, {1, 1e-6, 1}});
  add("Plane", Plane{{0, 2, 0}, 0.5});
  add("TiltedPlane", Plane{{1, -2, 0.5}, -0.25});
  add("Cylinder", Cylinder{{0, -1, 0}, {0, 1, 0}, 0.7});
  add("TiltedCylinder", Cylinder{{1, 2, 3}, {-1, 0.5, 3.5}, 0.2});
  add("LongCylinder", Cylinder{{-20, 0, 0}, {20, 1, 0}, 0.3});
  add("OpenCylinder", Cylinder{{0, 0, 0}, {1, 1, 0}, 1, true});
  add("Cone", Cone{{0, -1, 0}, 1, {0, 1, 0}, 0});
  add("SwappedCone", Cone{{0, -1, 0}, 0, {0.5, 1, 0}, 0.8});
  add("Frustum", Cone{{1, 0, 0}, 0.9, {0, 2, -1}, 0.4});
  add("OpenCone", Cone{{0, 0, 0}, 1, {0, 1, 0}, 0.2, true});
  add("Ellipsoid", quadric({1, 4, 2, 0, 0, 0, 0.5, 0, 0, -1}));
  add("TurnedEllipsoid", quadric({2, 3, 4, 1, -1, 0.5, 0.3, -0.2, 0.1, -1}));
  add("QuadricCylinder", quadric({1, 0, 1, 0, 0, 0, 0, 0, 0, -1}));
  add("Paraboloid", quadric({1, 0, 1, 0, 0, 0, 0, -1, 0, 0}));
  add("QuadricSlab", quadric({1, 0, 0, 0, 0, 0, 0, 0, 0, -1}));
  add("QuadricPlane", quadric({0, 0, 0, 0, 0, 0, 1, 2, 0, -0.5}));
  add("RoundSuperellipsoid", Superellipsoid{1, 1});
  add("RoundedBox", Superellipsoid{0.3, 0.25});
  add("SharpBox", Superellipsoid{0.01, 0.02});
  add("RoundedCylinder", Superellipsoid{1, 0.1});
  add("Ovus", Ovus{1, 0.5});
  add("OvusUpsideDown", Ovus{1, 1.4});
  add("OvusOfOneSphere", Ovus{1, 2.5});
  add("Octahedron", Superellipsoid{2, 2});
}

void add_quartics(std::vector<ShapeSample>& all) {
  const auto add = [&](const char* name, ShapeData data) { all.push_back({name, data}); };
  add("Hyperboloid", quadric({1, -1, 1, 0, 0, 0, 0, 0, 0, -0.25}));
  add("TwoSheets", quadric({1, -1, 1, 0, 0, 0, 0, 0, 0, 0.25}));
  add("QuadricCone", quadric({1, -1, 1, 0, 0, 0, 0, 0, 0, 0}));
  add("Saddle", quadric({0, 0, 0, 1, 0, 0, 0, 0, 1, 0}));
  add("Torus", Torus{1, 0.25});
  add("ThinTorus", Torus{2, 0.02});
  add("HornTorus", Torus{1, 1});
  add("Spindle", Torus{0.5, 1});
  add("BallTorus", Torus{0, 1});
  add("PinchedSuperellipsoid", Superellipsoid{3, 2.5});
  add("HalfPinchedSuperellipsoid", Superellipsoid{0.5, 3});
  add("SphereAsPoly", poly(2, {{1, 2, 0, 0}, {1, 0, 2, 0}, {1, 0, 0, 2}, {-1, 0, 0, 0}}));
  add("CubicPoly", poly(3, {{1, 3, 0, 0}, {1, 0, 1, 1}, {-1, 0, 0, 1}, {0.2, 0, 0, 0}}));
  add("QuarticPoly", poly(4, {{1, 4, 0, 0}, {1, 0, 4, 0}, {1, 0, 0, 4}, {-1, 0, 0, 0}}));
  add("OcticPoly",
      poly(8, {{1, 8, 0, 0}, {1, 0, 8, 0}, {1, 0, 0, 8}, {-1, 2, 2, 0}, {-0.3, 0, 0, 0}}));
}

void add_others(std::vector<ShapeSample>& all) {
  const auto add = [&](std::string name, ShapeData data) { all.push_back({name, data}); };
  add("Disc", Disc{{1, 0, 2}, {1, 1, 0.3}, 1.5});
  add("Annulus", Disc{{0, 0, 0}, {0, 1, 0}, 1, 0.5});
  add("Triangle", Triangle{{0, 0, 0}, {2, 0.3, 0}, {0.2, 1.5, 1}, {}});
  add("SheetMesh", octahedron({}));
  add("SolidMesh", octahedron({0.3, 1, 0.2}));
  Polygon star;
  star.outlines = {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0.7, 0}, {0, 2, 0}}};
  add("Polygon", star);
  for (const bool conic : {false, true}) {
    const std::string kind = conic ? "Conic" : "";
    add(kind + "LinearPrism",
        prism(OutlineSpline::kLinear, conic, {{1, 1}, {-1, 1}, {-1, -1}, {0.5, -1}, {0, 0}}));
    add(kind + "QuadraticPrism",
        prism(OutlineSpline::kQuadratic, conic,
              {{0.3, -1.2}, {1, -1}, {1.4, 1}, {-1, 1.2}, {-1, -1}, {1, -1}}));
    add(kind + "CubicPrism",
        prism(OutlineSpline::kCubic, conic,
              {{0.3, -1.2}, {1, -1}, {1.4, 1}, {0, 0.3}, {-1, 1.2}, {-1, -1}, {1, -1}, {2, 2}}));
    add(kind + "BezierPrism",
        prism(OutlineSpline::kBezier, conic,
              {{0, 0}, {0, 1}, {1, 2}, {2, 2}, {2, 2}, {3, 1}, {2, 0}, {0, 0}}));
  }
  add("LinearLathe", Lathe{OutlineSpline::kLinear, {{1, 0}, {2, 0}, {2, 1}, {1.2, 2}, {1, 0}}});
  add("LatheToTheAxis",
      Lathe{OutlineSpline::kLinear, {{0, 0}, {1, 0.2}, {0.5, 1}, {0.8, 2}, {0, 1.5}}});
  add("OpenLathe", Lathe{OutlineSpline::kLinear, {{1, 0}, {1.5, 1}, {0.7, 2}}});
  add("QuadraticLathe",
      Lathe{OutlineSpline::kQuadratic, {{0.3, -1.2}, {1, -1}, {1.4, 0}, {0.7, 0.5}, {0, 1}}});
  add("CubicLathe", Lathe{OutlineSpline::kCubic,
                          {{2, 1},
                           {2, -1},
                           {3, -1},
                           {3.4, -2},
                           {4, -1.1},
                           {3.6, 0},
                           {3, 1},
                           {2, 1},
                           {2, -1},
                           {3, -1}}});
  add("BezierLathe",
      Lathe{OutlineSpline::kBezier,
            {{1, 0}, {2, 0.3}, {2, 0.7}, {1, 1}, {1, 1}, {0.5, 1.3}, {0, 1.7}, {0, 2}}});
  for (const bool open : {false, true}) {
    add(open ? "OpenSor" : "Sor",
        Sor{{{0, 0}, {0.12, 0}, {0.62, 0.54}, {0.21, 0.83}, {0.19, 0.96}, {0.29, 1}, {0.47, 1.03}},
            open});
  }
  for (const SphereSweepSpline spline :
       {SphereSweepSpline::kLinear, SphereSweepSpline::kBSpline, SphereSweepSpline::kCubic}) {
    const char* names[] = {"LinearSweep", "BSplineSweep", "CubicSweep"};
    add(names[static_cast<int>(spline)], SphereSweep{spline,
                                                     {{{-1, 0, 0}, 0.3},
                                                      {{0, 0.2, 0}, 0.4},
                                                      {{1, 1, 0.1}, 0.5},
                                                      {{2, 0, 0.4}, 0.2},
                                                      {{3, 1, 0}, 0.3}}});
  }
  add("FlatSweep",
      SphereSweep{SphereSweepSpline::kCubic,
                  {{{-1, 0, 0}, 0.1}, {{0, 1, 0}, 0.1}, {{1, 0, 0}, 0.1}, {{0, -1, 0}, 0.1}}});
  add("SweepOfDots", SphereSweep{SphereSweepSpline::kLinear,
                                 {{{0, 0, 0}, 1}, {{0.2, 0, 0}, 0.2}, {{2, 0, 0}, 0}}});
  add("Blob", blob());
  add("HeightField", height_field(0, false));
  add("FloodedHeightField", height_field(0.4, true));
  add("Text", text());
  add("BicubicPatch", patch(0));
  add("FlatBicubicPatch", patch(0.1));
}

void add_fractals(std::vector<ShapeSample>& all) {
  const auto add = [&](std::string name, ShapeData data) { all.push_back({name, data}); };
  constexpr auto kQuaternion = JuliaAlgebra::kQuaternion;
  constexpr auto kHypercomplex = JuliaAlgebra::kHypercomplex;
  add("Julia", julia(kQuaternion, JuliaFunction::kSqr, 6));
  add("CubicJulia", julia(kQuaternion, JuliaFunction::kCube, 4));
  add("HypercomplexJulia", julia(kHypercomplex, JuliaFunction::kSqr, 4));
  add("JuliaOfExponentials", julia(kHypercomplex, JuliaFunction::kExp, 2));
  JuliaFractal sliced = julia(kQuaternion, JuliaFunction::kSqr, 5);
  sliced.slice_normal = {0.3, -0.2, 0.4, 0.8};
  sliced.slice_distance = 0.1;
  add("SlicedJulia", sliced);
}

}  // namespace

std::vector<ShapeSample> shape_samples() {
  std::vector<ShapeSample> all;
  add_convex(all);
  add_quartics(all);
  add_others(all);
  add_isosurfaces(all);
  add_fractals(all);
  return all;
}

const ShapeOptions& sample_options() {
  static const SampleFields fields;
  static const ShapeOptions options{.fields = &fields};
  return options;
}

}  // namespace dioptre
