// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/pov/syntax/syntax_test_support.h"

namespace dioptre::pov {
namespace {

TEST(Shapes, ParametersAreAsWritten) {
  EXPECT_EQ(shape_of<Sphere>("sphere { <1, 2, 3>, 4 }"), (Sphere{{1, 2, 3}, 4}));
  EXPECT_EQ(shape_of<Box>("box { -1 <1, 2, 3> }"), (Box{{-1, -1, -1}, {1, 2, 3}}));
  EXPECT_EQ(shape_of<Cylinder>("cylinder { 0, y, 2 open }"), (Cylinder{{}, {0, 1, 0}, 2, true}));
  EXPECT_EQ(shape_of<Cone>("cone { 0, 1, 2*y, 0.5 }"), (Cone{{}, 1, {0, 2, 0}, 0.5, false}));
  EXPECT_EQ(shape_of<Plane>("plane { z, -3 }"), (Plane{{0, 0, 1}, -3}));
  EXPECT_EQ(shape_of<Torus>("torus { 3, 1 sturm }"), (Torus{3, 1}));
  EXPECT_EQ(shape_of<Disc>("disc { 0, y, 2, 1 }"), (Disc{{}, {0, 1, 0}, 2, 1}));
  EXPECT_EQ(shape_of<Quadric>("quadric { <1,2,3>, <4,5,6>, <7,8,9>, 10 }"),
            (Quadric{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, 10}));
}

TEST(Shapes, CommasMayBeLeftOut) {
  EXPECT_EQ(root_of("sphere { <1, 2, 3> 4 }"), root_of("sphere { <1, 2, 3>, 4 }"));
  EXPECT_EQ(root_of("cone { 0 1 y 0 }"), root_of("cone { 0, 1, y, 0 }"));
}

TEST(Shapes, APolynomialHasAsManyCoefficientsAsItsOrderSays) {
  EXPECT_EQ(shape_of<Poly>("cubic { <1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20> }")
                .coefficients.size(),
            20u);
  EXPECT_EQ(shape_of<Poly>("poly { 2, <1,2,3,4,5,6,7,8,9,10> sturm }").sturm, true);
}

TEST(Shapes, APrismIsCutWhereAnOutlineCloses) {
  const Prism prism = shape_of<Prism>(
      "prism { linear_spline 0, 1, 8, <0,0> <4,0> <0,4> <0,0> <1,1> <2,1> <1,2> <1,1> }");
  ASSERT_EQ(prism.outlines.size(), 2u);
  EXPECT_EQ(prism.outlines[0].size(), 4u);
  EXPECT_EQ(prism.outlines[1].front(), (Vec2{1, 1}));
}

TEST(Shapes, RevolvedCurvesAreAsWritten) {
  EXPECT_EQ(shape_of<Superellipsoid>("superellipsoid { <.2, .3> }"), (Superellipsoid{0.2, 0.3}));
  EXPECT_EQ(shape_of<Lathe>("lathe { quadratic_spline 3, <0, 0>, <1, 1> <0, 2> sturm }"),
            (Lathe{OutlineSpline::kQuadratic, {{0, 0}, {1, 1}, {0, 2}}, true}));
  EXPECT_EQ(shape_of<Sor>("sor { 4, <0, 0> <1, 1> <1, 2> <0, 3> open }"),
            (Sor{{{0, 0}, {1, 1}, {1, 2}, {0, 3}}, true}));
}

TEST(Shapes, ASphereSweepIsAsWritten) {
  EXPECT_EQ(shape_of<SphereSweep>("sphere_sweep { linear_spline, 2, 0, 1, x 2 tolerance 0.1 }"),
            (SphereSweep{SphereSweepSpline::kLinear, {{{}, 1}, {{1, 0, 0}, 2}}, 0.1}));
  EXPECT_EQ(shape_of<Ovus>("ovus { 1, 0.5 }"), (Ovus{1, 0.5}));
}

TEST(Shapes, APrismClosesWithinRounding) {
  for (const char* size : {"1e-9", "1", "1e9"}) {
    const std::string program = std::string("#declare S=") + size +
                                "; prism { linear_spline 0, 1, 4, <S*cos(0), S*sin(0)>, "
                                "<-S, S>, <-S, -S>, <S*cos(2*pi), S*sin(2*pi)> }";
    EXPECT_EQ(said(program), "");
    const Prism prism = shape_of<Prism>(program);
    ASSERT_EQ(prism.outlines.size(), 1u);
    EXPECT_EQ(prism.outlines[0].front(), prism.outlines[0].back());
  }
  EXPECT_NE(said("prism { linear_spline 0, 1, 4, <1, 0> <0, 1> <0, 0> <1, 1e-6> }")
                .find("the outline of the prism is open: it is closed"),
            std::string::npos);
}

TEST(Shapes, AMesh2SharesItsCorners) {
  const Mesh mesh = shape_of<Mesh>(
      "mesh2 { vertex_vectors { 4, 0, x, y, x+y } face_indices { 2, <0,1,2>, <1,2,3> } }");
  EXPECT_EQ(mesh.data->corners.size(), 4u);
  EXPECT_EQ(mesh.data->faces.size(), 2u);
}

TEST(Modifiers, TransformationsActInOrder) {
  const Affine map = root_of("sphere { 0, 1 scale 2 translate x rotate 90*z }").transform;
  EXPECT_EQ(map, then(then(scaling({2, 2, 2}), translation({1, 0, 0})), rotation({0, 0, 90})));
}

TEST(Modifiers, AZeroColumnOfAMatrixIsAScaleOf1) {
  EXPECT_EQ(root_of("sphere { 0, 1 matrix <0,0,0, 0,0,0, 0,0,0, 1,2,3> }").transform,
            translation({1, 2, 3}));
  EXPECT_EQ(root_of("sphere { 0, 1 matrix <0,2,0, 0,1,0, 0,0,3, 0,0,0> }").transform,
            (Affine{{1, 2, 0}, {0, 1, 0}, {0, 0, 3}, {}}));
}

TEST(Modifiers, WhatFlattensIsAnError) {
  for (const char* move :
       {"matrix <1,1,1, 1,1,1, 1,1,1, 0,0,0>", "matrix <0,0,0, 1,1,0, 0,0,1, 0,0,0>",
        "scale 1e-200 scale 1e-200", "translate 1e308*10"}) {
    const std::string text = said(std::string("sphere { 0, 1 ") + move + " }");
    EXPECT_EQ(text.find("t.pov:2:15: error: the transformation"), 0u) << text;
  }
}

TEST(Modifiers, EveryObjectModifierIsRead) {
  for (const char* modifier : {"radiosity { importance 0.5 }", "no_radiosity", "cutaway_textures",
                               "split_union off", "hierarchy off", "sturm", "double_illuminate"}) {
    EXPECT_EQ(said(std::string("difference { sphere { 0, 1 } box { 0, 1 } ") + modifier + " }")
                  .find("error"),
              std::string::npos)
        << modifier;
  }
}

TEST(Modifiers, OnlyTexturesGivenBeforeAMoveAreMoved) {
  const std::string red = "pigment { rgb x }";
  const Affine move = translation({5, 0, 0});
  EXPECT_EQ(root_of("sphere { 0, 1 " + red + " translate 5*x }").texture_transform, move);
  EXPECT_EQ(root_of("sphere { 0, 1 translate 5*x " + red + " }").texture_transform, Affine{});
}

TEST(Modifiers, ClipsMoveWithTheirObject) {
  const Scene scene = scene_of("sphere { 0, 1 clipped_by { plane { x, 0 } } translate 5*x }");
  const Object& object = at(scene.objects, scene.roots.at(0));
  ASSERT_EQ(object.clipped_by.size(), 1u);
  EXPECT_EQ(at(scene.objects, object.clipped_by[0]).transform, translation({5, 0, 0}));
}

TEST(Modifiers, InverseTwiceIsNothing) {
  EXPECT_TRUE(root_of("sphere { 0, 1 inverse }").inverse);
  EXPECT_FALSE(root_of("sphere { 0, 1 inverse inverse }").inverse);
}

TEST(Declarations, AUseMayBeChangedWithoutTheDeclaration) {
  const Scene scene = scene_of(
      "#declare Ball = sphere { 0, 1 }\n object { Ball translate x no_shadow } object { Ball }");
  ASSERT_EQ(scene.roots.size(), 2u);
  const Object& first = at(scene.objects, scene.roots[0]);
  const Object& second = at(scene.objects, scene.roots[1]);
  EXPECT_TRUE(first.no_shadow);
  EXPECT_FALSE(second.no_shadow);
  EXPECT_EQ(second.transform, Affine{});
  EXPECT_EQ(first.name, "Ball");
}

TEST(Declarations, UsesOfOneTextureShareIt) {
  const Scene scene = scene_of(
      "#declare T = texture { pigment { rgb x } }\n"
      "#for (I, 1, 100) sphere { I*x, 1 texture { T } } #end");
  EXPECT_EQ(scene.roots.size(), 100u);
  EXPECT_LE(scene.textures.size(), 2u);
}

TEST(Declarations, WhatALoopWritesAgainIsKeptOnce) {
  const Scene scene = scene_of("#for (I, 1, 100) sphere { I*x, 1 pigment { rgb x } } #end");
  EXPECT_LE(scene.textures.size(), 2u);
  EXPECT_LE(scene.pigments.size(), 2u);
}

TEST(Csg, ACompositeIsAUnion) {
  EXPECT_EQ(root_of("composite { sphere { 0, 1 } }"), root_of("union { sphere { 0, 1 } }"));
}

TEST(Csg, ARayAtNothingRenderedIsSaidOnce) {
  const std::string text = said(
      "#declare U = union { };\n#for (I, 1, 3)\n"
      "#declare A = trace(U, 0, z);\n#declare B = trace(U, 0, z);\n#end");
  const std::string warning = "there is nothing in 'U' that is rendered: no ray meets it";
  const std::size_t first = text.find(warning);
  EXPECT_NE(first, std::string::npos) << text;
  EXPECT_EQ(text.find(warning, first + 1), std::string::npos) << text;
}

TEST(Csg, ChildrenComeBeforeTheirWholes) {
  const Scene scene =
      scene_of("difference { box { -1, 1 } union { sphere { 0, 1 } torus {1, .1} } }");
  const Object& whole = at(scene.objects, scene.roots.at(0));
  const Csg& csg = std::get<Csg>(whole.geometry);
  EXPECT_EQ(csg.operation, CsgOperation::kDifference);
  ASSERT_EQ(csg.children.size(), 2u);
  for (const ObjectId child : csg.children) EXPECT_LT(child.index, scene.roots[0].index);
}

TEST(Csg, LightsOfAUnionShineInTheWorldWhereItIsPut) {
  const Scene scene = scene_of(
      "#declare Lamp = union { sphere { 0, 1 } light_source { 2*y, rgb 1 } translate x }\n"
      "object { Lamp translate 10*x }");
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].location, (Vec3{11, 2, 0}));
  EXPECT_EQ(scene.roots.size(), 1u);
}

TEST(Csg, ShapesThatAreNotRenderedAreLeftOutWithANotice) {
  const std::string program =
      "union { sphere { 0, 1 } parametric { function { u } function { v } function { u*v } "
      "<0, 0>, <1, 1> } }";
  EXPECT_EQ(std::get<Csg>(root_of(program).geometry).children.size(), 1u);
  EXPECT_NE(said(program).find("parametric is not rendered yet: ignored"), std::string::npos);
}

TEST(Shapes, JuliaFractalsAndPatchesAreReadWithTheirModifiersInAnyOrder) {
  JuliaFractal julia;
  julia.parameter = {0.1, 0.2, 0.3, 0.4};
  EXPECT_EQ(shape_of<JuliaFractal>("julia_fractal { <.1, .2, .3, .4> }"), julia);
  julia.algebra = JuliaAlgebra::kHypercomplex;
  julia.function = JuliaFunction::kPwr;
  julia.exponent = {2, -1};
  julia.max_iteration = 5;
  julia.precision = 1;
  julia.slice_normal = {0, 1, 0, 2};
  julia.slice_distance = 0.5;
  EXPECT_EQ(shape_of<JuliaFractal>("julia_fractal { <.1, .2, .3, .4> pwr(2, -1) precision 0.1 "
                                   "slice <0, 1, 0, 2>, 0.5 max_iteration 5 hypercomplex }"),
            julia);
  EXPECT_NE(said("julia_fractal { <.1, .2, .3, .4> sin }").find("write hypercomplex"),
            std::string::npos);
  BicubicPatch patch;
  patch.points.fill({1, 2, 3});
  patch.u_steps = 3;
  patch.v_steps = 2;
  patch.flatness = 0.25;
  patch.uv_corners = {Vec2{0, 0}, Vec2{0, 1}, Vec2{1, 1}, Vec2{1, 0}};
  std::string points;
  for (int i = 0; i < 16; ++i) points += ", <1, 2, 3>";
  EXPECT_EQ(shape_of<BicubicPatch>("bicubic_patch { v_steps 2 type 0 flatness 0.25 u_steps 3 "
                                   "uv_vectors <0, 0> <0, 1> <1, 1> <1, 0>" +
                                   points + " }"),
            patch);
}

TEST(Lights, LooksLikeStandsAtTheLightAndCastsNoShadow) {
  const Scene scene =
      scene_of("light_source { y, rgb 1 looks_like { sphere { 0, 1 } } translate x }");
  ASSERT_EQ(scene.roots.size(), 1u);
  const Object& bulb = at(scene.objects, scene.roots[0]);
  EXPECT_TRUE(bulb.no_shadow);
  EXPECT_EQ(bulb.transform.point({}), scene.lights.at(0).location);
}

}  // namespace
}  // namespace dioptre::pov
