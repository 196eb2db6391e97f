// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/pov/syntax/syntax_test_support.h"

namespace dioptre::pov {
namespace {

TEST(SyntaxErrors, PointAtTheShapeThatCannotBe) {
  EXPECT_EQ(said("cylinder { y, y, 1 }"),
            "t.pov:2:12: error: the ends of the cylinder are the same point\n"
            "   2 | cylinder { y, y, 1 }\n"
            "     |            ^\n"
            "     = note: give it a length\n");
  EXPECT_EQ(said("plane { 0, 1 }"),
            "t.pov:2:9: error: the normal of the plane is zero\n"
            "   2 | plane { 0, 1 }\n"
            "     |         ^\n"
            "     = note: give it a direction, such as y\n");
  EXPECT_EQ(said("poly { 36, <1> }"),
            "t.pov:2:8: error: the order of a poly must be from 2 to 35\n"
            "   2 | poly { 36, <1> }\n"
            "     |        ^\n");
}

TEST(SyntaxErrors, SayWhatWasExpected) {
  for (const auto& [program, message] :
       {std::pair{"sphere { 0, 1 sphere { 0, 1 } }", "expected an object modifier or '}'"},
        std::pair{"sphere { 0, 1 finish { ambeint 1 } }", "expected a property of the finish"},
        std::pair{"sphere { 0, 1 pigment { checker color_map { [0 rgb 1] } } }",
                  "this pattern takes a list, not a color_map"},
        std::pair{"camera { location }", "expected a number or vector"},
        std::pair{"union { sphere { 0, 1 } fog }", "expected an object modifier or '}'"},
        std::pair{"mesh2 { vertex_vectors { 1, 0 } face_indices { 1, <0, 1, 2> } }",
                  "an index into the vertex_vectors is out of range: there are 1"},
        std::pair{"nonsense { }", "an object, a light source or another item of a scene"}}) {
    EXPECT_NE(said(program).find(message), std::string::npos) << said(program);
  }
}

TEST(SyntaxWarnings, ScalingByNothingIsScalingByOne) {
  EXPECT_NE(said("sphere { 0, 1 scale <1, 0, 2> }").find("scaling by 0 is taken as scaling by 1"),
            std::string::npos);
  EXPECT_EQ(root_of("sphere { 0, 1 scale <1, 0, 2> }").transform, scaling({1, 1, 2}));
}

TEST(SyntaxWarnings, AFlatTriangleIsLeftOut) {
  EXPECT_TRUE(scene_of("triangle { 0, x, 2*x }").roots.empty());
}

TEST(SyntaxNotices, EveryBlockThatIsNotRenderedIsNamedOnce) {
  for (const auto& [name, program] :
       {std::pair{"media",
                  "media { scattering { 1, rgb 1 extinction 0.5 } samples 1, 2 "
                  "density { spherical density_map { [0 rgb 0] [1 rgb 1] } } }"},
        std::pair{"photons", "global_settings { photons { count 1000 media 10, 2 } }"},
        std::pair{"radiosity", "global_settings { radiosity { count 50, 100 error_bound 1 } }"},
        std::pair{"parametric",
                  "parametric { function { u } function { v } function { u*v } <0, 0>, "
                  "<1, 1> contained_by { box { 0, 1 } } precompute 5 x, y, z }"}}) {
    const std::string text = said(std::string(program) + "\n" + program);
    const std::string notice = std::string(name) + " is not rendered yet: ignored";
    EXPECT_EQ(text.find("error"), text.find("error_bound")) << text;
    const std::size_t first = text.find(notice);
    EXPECT_NE(first, std::string::npos) << text;
    EXPECT_EQ(text.find(notice, first + 1), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace dioptre::pov
