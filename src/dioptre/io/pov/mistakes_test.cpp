// SPDX-License-Identifier: Apache-2.0
// What is said of the commonest mistakes, word for word.
#include <gtest/gtest.h>

#include <filesystem>

#include "dioptre/io/pov/language_test_support.h"

namespace dioptre::pov {
namespace {

struct Mistake {
  std::string name, program, message;
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.name; }

class Mistakes : public ::testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, AreExplained) { EXPECT_EQ(said(GetParam().program + "\n"), GetParam().message); }

const std::string here = std::filesystem::current_path().string();

INSTANTIATE_TEST_SUITE_P(
    Commonest, Mistakes,
    ::testing::Values(
        Mistake{"AMissingBraceBeforeAnObject", "sphere { 0, 1\nbox { 0, 1 }",
                "t.pov:3:1: error: expected an object modifier or '}', found 'box'\n"
                "   3 | box { 0, 1 }\n"
                "     | ^\n"},
        Mistake{"AMissingBraceAtTheEnd", "union {\n  sphere { 0, 1 }",
                "t.pov:4:1: error: expected an object modifier or '}', found the end of the file\n"
                "     = note: the '{' at t.pov:2:7 has no '}'\n"},
        Mistake{"OneBraceTooMany", "sphere { 0, 1 } }",
                "t.pov:2:17: error: expected an object, a light source or another item of a scene, "
                "found '}'\n"
                "   2 | sphere { 0, 1 } }\n"
                "     |                 ^\n"},
        Mistake{"AMissingParenthesis", "#declare A = (1 + 2;",
                "t.pov:2:20: error: expected ')' to close the parenthesis, found ';'\n"
                "   2 | #declare A = (1 + 2;\n"
                "     |                    ^\n"},
        Mistake{"AMissingAngleBracket", "#declare B = <1, 2;",
                "t.pov:2:19: error: expected a number or vector, found ';'\n"
                "   2 | #declare B = <1, 2;\n"
                "     |                   ^\n"},
        Mistake{"AnUnknownIdentifier", "#declare Radius = 1;\nsphere { 0, Radios }",
                "t.pov:3:13: error: 'Radios' is not declared\n"
                "   3 | sphere { 0, Radios }\n"
                "     |             ^\n"
                "     = note: did you mean 'Radius'?\n"},
        Mistake{"AnUnknownObject", "object { Foo }",
                "t.pov:2:10: error: expected an object, found 'Foo'\n"
                "   2 | object { Foo }\n"
                "     |          ^\n"
                "     = note: nothing of that name has been declared\n"},
        Mistake{"AModuloByZero", "#debug str(mod(1,0),0,1)\n#debug str(div(7,0),0,1)",
                "t.pov:2:19: warning: mod by zero\n"
                "   2 | #debug str(mod(1,0),0,1)\n"
                "     |                   ^\n"
                "-nan"
                "t.pov:3:19: warning: div by zero\n"
                "   3 | #debug str(div(7,0),0,1)\n"
                "     |                   ^\n"
                "-2147483648.0"},
        Mistake{"AMisspeltKeyword", "sphere { 0, 1 pigmet { rgb 1 } }",
                "t.pov:2:15: error: expected an object modifier or '}', found 'pigmet'\n"
                "   2 | sphere { 0, 1 pigmet { rgb 1 } }\n"
                "     |               ^\n"
                "     = note: nothing of that name has been declared; did you mean 'pigment'?\n"},
        Mistake{"AMisspeltProperty", "sphere { 0, 1 finish { difuse 0.9 } }",
                "t.pov:2:24: error: expected a property of the finish or '}', found 'difuse'\n"
                "   2 | sphere { 0, 1 finish { difuse 0.9 } }\n"
                "     |                        ^\n"
                "     = note: nothing of that name has been declared; did you mean 'diffuse'?\n"},
        Mistake{"AMisspeltDirective", "#decalre A = 5;",
                "t.pov:2:1: error: '#decalre' is no directive\n"
                "   2 | #decalre A = 5;\n"
                "     | ^\n"
                "     = note: did you mean 'declare'?\n"},
        Mistake{"AMissingParameter", "sphere { <0, 0, 0> }",
                "t.pov:2:20: error: expected a number or vector, found '}'\n"
                "   2 | sphere { <0, 0, 0> }\n"
                "     |                    ^\n"},
        Mistake{"AMinusThatJoinsWhatACommaShouldPart", "sphere { 0 -1 }",
                "t.pov:2:15: error: expected a number or vector, found '}'\n"
                "   2 | sphere { 0 -1 }\n"
                "     |               ^\n"},
        Mistake{"AStringForAVector", "sphere { \"a\", 1 }",
                "t.pov:2:10: error: expected a number or vector, found a string\n"
                "   2 | sphere { \"a\", 1 }\n"
                "     |          ^\n"},
        Mistake{"AVectorForANumber", "sphere { 0, <1, 2, 3> }",
                "t.pov:2:13: error: expected a number, found a vector\n"
                "   2 | sphere { 0, <1, 2, 3> }\n"
                "     |             ^\n"
                "     = note: take one of its components, as in V.x\n"},
        Mistake{"ATextureOnItsOwn", "texture { pigment { rgb 1 } }",
                "t.pov:2:1: error: expected an object, a light source or another item of a scene, "
                "found 'texture'\n"
                "   2 | texture { pigment { rgb 1 } }\n"
                "     | ^\n"},
        Mistake{"AMissingInclude", "#include \"colours.inc\"",
                "t.pov:2:10: error: cannot find the file 'colours.inc'; looked in " + here +
                    "\n"
                    "   2 | #include \"colours.inc\"\n"
                    "     |          ^\n"},
        Mistake{"AMissingImage", "sphere { 0, 1 pigment { image_map { png \"wood.png\" } } }",
                "t.pov:2:41: error: cannot find the file 'wood.png'; looked in " + here +
                    "\n"
                    "   2 | sphere { 0, 1 pigment { image_map { png \"wood.png\" } } }\n"
                    "     |                                         ^\n"},
        Mistake{"AnOpenIf", "#if (1)\nsphere { 0, 1 }",
                "t.pov:2:1: error: #if without #end\n"
                "   2 | #if (1)\n"
                "     | ^\n"},
        Mistake{"AnOpenLoop", "#for (I, 1, 10)\n  sphere { I, 1 }",
                "t.pov:2:1: error: #for without #end\n"
                "   2 | #for (I, 1, 10)\n"
                "     | ^\n"},
        Mistake{"AnEndWithoutABeginning", "#end",
                "t.pov:2:1: error: #end without an #if, #while, #for, #switch or #macro before it\n"
                "   2 | #end\n"
                "     | ^\n"},
        Mistake{"AnOpenString", "#declare S = \"abc;\nsphere { 0, 1 }",
                "t.pov:2:14: error: a string has no closing '\"'\n"
                "   2 | #declare S = \"abc;\n"
                "     |              ^\n"},
        Mistake{"AnOpenComment", "/* a comment\nsphere { 0, 1 }",
                "t.pov:2:1: error: a comment has no closing '*/'\n"
                "   2 | /* a comment\n"
                "     | ^\n"},
        Mistake{"TooFewMacroArguments", "#macro M(A, B) sphere { A, B } #end\nM(1)",
                "t.pov:3:1: error: the macro M takes 2 arguments, found 1\n"
                "   3 | M(1)\n"
                "     | ^\n"},
        Mistake{"TooManyMacroArguments", "#macro M(A) sphere { A, 1 } #end\nM(0, 1)",
                "t.pov:3:1: error: the macro M takes 1 argument, found more\n"
                "   3 | M(0, 1)\n"
                "     | ^\n"},
        Mistake{"AMacroWithoutParentheses", "#macro M() #end\nM\nsphere { 0, 1 }",
                "t.pov:4:1: error: expected '(' after the macro M, found 'sphere'\n"
                "   4 | sphere { 0, 1 }\n"
                "     | ^\n"
                "     = note: a call needs parentheses even without arguments\n"},
        Mistake{"AnErrorWithinAMacro", "#macro M(A)\n  sphere { A, B }\n#end\nM(0)",
                "t.pov:3:15: error: 'B' is not declared\n"
                "   3 |   sphere { A, B }\n"
                "     |               ^\n"
                "     = note: in macro M called at t.pov:5:1\n"},
        Mistake{"ASubscriptTooLarge", "#declare A = array[3] { 1, 2, 3 };\n#declare B = A[3];",
                "t.pov:3:14: error: the subscript 3 is outside the array, whose size is 3\n"
                "   3 | #declare B = A[3];\n"
                "     |              ^\n"
                "     = note: subscripts count from 0\n"},
        Mistake{"AnUnknownFunctionParameter", "#declare F = function(x, y) { x + z };",
                "t.pov:2:35: error: expected a number, a parameter or a function in the function, "
                "found 'z'\n"
                "   2 | #declare F = function(x, y) { x + z };\n"
                "     |                                   ^\n"},
        Mistake{"AMissingSemicolon", "#declare A = 5\nsphere { 0, A }",
                "t.pov:2:10: warning: the declaration of A has no ';' at its end\n"
                "   2 | #declare A = 5\n"
                "     |          ^\n"},
        Mistake{"ANewerVersion", "#version 4.0;",
                "t.pov:2:10: error: this is POV-Ray 3.7's language, version 4.0 is not known\n"
                "   2 | #version 4.0;\n"
                "     |          ^\n"},
        Mistake{"AFileThatIsNotOpen", "#read (F, A)",
                "t.pov:2:8: error: 'F' is no open file\n"
                "   2 | #read (F, A)\n"
                "     |        ^\n"
                "     = note: open it with #fopen\n"}),
    [](const auto& mistake) { return mistake.param.name; });

}  // namespace
}  // namespace dioptre::pov
