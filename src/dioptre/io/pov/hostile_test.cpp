// SPDX-License-Identifier: Apache-2.0
// What the language refuses, word for word, and that nothing makes it run away.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dioptre/io/pov/language_test_support.h"

namespace dioptre::pov {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(LanguageErrors, ShowTheLineACaretAndTheWayThere) {
  EXPECT_EQ(said("#macro Foo(p)\n  #debug str(p[7],0,0)\n#end\n#declare A=array[2]{1,2}\nFoo(A)"),
            "t.pov:3:14: error: the subscript 7 is outside the array, whose size is 2\n"
            "   3 |   #debug str(p[7],0,0)\n"
            "     |              ^\n"
            "     = note: in macro Foo called at t.pov:6:1\n"
            "     = note: subscripts count from 0\n");
  EXPECT_EQ(said("#declare A = Foo;"),
            "t.pov:2:14: error: expected a value, found 'Foo'\n"
            "   2 | #declare A = Foo;\n"
            "     |              ^\n"
            "     = note: nothing of that name has been declared\n");
  EXPECT_EQ(said("#declare B = 1\n#debug \"x\""),
            "t.pov:2:10: warning: the declaration of B has no ';' at its end\n"
            "   2 | #declare B = 1\n"
            "     |          ^\n"
            "x");
}

struct Refused {
  std::string program;
  const char* reason;
};

void PrintTo(const Refused& refused, std::ostream* out) { *out << refused.reason; }

class Refusal : public ::testing::TestWithParam<Refused> {};

TEST_P(Refusal, SaysWhereAndWhy) {
  const std::string text = said(GetParam().program);
  EXPECT_THAT(text, StartsWith("t.pov:"));
  EXPECT_THAT(text, HasSubstr(GetParam().reason));
}

std::string deep(const std::string& begin, const std::string& level) {
  std::string text = begin;
  for (int i = 0; i < 100'000; ++i) text += level;
  return text;
}

INSTANTIATE_TEST_SUITE_P(
    Syntax, Refusal,
    ::testing::Values(
        Refused{"/* abc", "2:1: error: a comment has no closing '*/'"},
        Refused{"#debug \"abc", "2:8: error: a string has no closing '\"'"},
        Refused{"#declare A = 1e999;", "a number is too large"},
        Refused{"#end", "#end without an #if, #while, #for, #switch or #macro before it"},
        Refused{"#else", "#else without #if or #switch"}, Refused{"#if (1)", "#if without #end"},
        Refused{"#version 99.0;", "version 99.0"}, Refused{"#foo", "'#foo' is no directive"},
        Refused{"#declare V=<1,2,3>; #debug str(V,0,0)", "expected a number, found a vector"},
        Refused{"#declare x = 5;", "'x' is a reserved word"},
        Refused{"#macro F(a,b) #end F(1)", "the macro F takes 2 arguments, found 1"},
        Refused{"#declare f=function(x,y){x} #debug str(f(1),0,0)",
                "the function takes 2 arguments, found 1"},
        Refused{"#debug substr(\"abc\",10,5)", "substr reaches outside the string"},
        Refused{"#debug chr(-1)", "chr needs a number from 0 to 65535"},
        Refused{"#debug str(sqrt(-1),0,0)", "sqrt of a negative number"},
        Refused{"#debug str(rand(3),0,0)", "rand needs a stream made by seed"},
        Refused{"#declare A=array[-5];", "an array needs at least one element"},
        Refused{"#declare A=array[5]; #debug str(A[1],0,0)", "has no value yet"}));

INSTANTIATE_TEST_SUITE_P(
    Endless, Refusal,
    ::testing::Values(Refused{"#while(1) #end", "this #while never ends"},
                      Refused{"#for(I,0,1,0) #end", "the step of #for is 0"},
                      Refused{"#for(I,1e20,2e20,1) #end", "this #for never ends"},
                      Refused{"#macro A() A() #end A()", "more than 4000 levels of nesting"},
                      Refused{"#macro A(n) A(A(n)) #end A(1)", "more than 4000 levels of nesting"},
                      Refused{"#declare A=array[1e9];", "more than 67108864 elements in an array"},
                      Refused{"#declare S=\"ab\"; #for(I,1,40) #declare S=concat(S,S); #end",
                              "more than 67108864 bytes in a string"},
                      Refused{"#declare A=array[1]; #for(I,1,1e6) #declare A[0]=A; #end",
                              "more than 4000 levels of nesting"},
                      Refused{"#declare U=sphere{0,1} #for(I,1,1e6) "
                              "#declare U=union{object{U} sphere{I,1}} #end",
                              "solids are nested more than 4000 deep"},
                      Refused{"#debug str(1,1e9,0)", "more than 1000 characters"},
                      Refused{deep("#declare A=", "("), "more than 4000 levels of nesting"},
                      Refused{deep("#declare A=", "!"), "more than 4000 levels of nesting"},
                      Refused{deep("#declare A=", "<"), "more than 4000 levels of nesting"},
                      Refused{deep("#declare F=function{", "("),
                              "more than 4000 levels of nesting"},
                      Refused{deep("#declare A=(", "1?"), "more than 4000 levels of nesting"}));

INSTANTIATE_TEST_SUITE_P(
    Files, Refusal,
    ::testing::Values(Refused{"#fopen F \"/etc/passwd\" read", "'/etc/passwd' may not be read"},
                      Refused{"#include \"/etc/passwd\"", "'/etc/passwd' may not be read"},
                      Refused{"#fopen F \"/var/tmp/x\" write", "'/var/tmp/x' may not be written"},
                      Refused{"#fopen F \"/tmp/../var/tmp/x\" write", "may not be written"},
                      Refused{"#fopen F \"t.pov\" write", "may not be written: it is a scene"},
                      Refused{"#include \"no such file.inc\"",
                              "cannot find the file 'no such file.inc'"}));

TEST(LanguageBudgets, EachCanBeLoweredAndNamesItsOption) {
  LoadOptions options;
  options.budgets.steps = 1000;
  EXPECT_THAT(said("#declare I=0; #while(I<9) #declare I=I*1; #end", options),
              HasSubstr("error: more than 1000 steps"));
  options = {};
  options.budgets.nesting = 20;
  EXPECT_THAT(said(deep("#declare A=", "("), options),
              HasSubstr("raise the limit with --max-nesting"));
  options = {};
  options.budgets.objects = 100;
  EXPECT_THAT(said("#for(I,1,1e5) sphere{I,1} #end", options),
              HasSubstr("raise the limit with --max-objects"));
  options = {};
  options.budgets.array_elements = 100;
  EXPECT_THAT(said("#declare A=array[11][10];", options),
              HasSubstr("raise the limit with --max-array-elements"));
  options = {};
  options.budgets.string_bytes = 5;
  EXPECT_THAT(said("#debug concat(\"abc\",\"def\")", options),
              HasSubstr("raise the limit with --max-string-bytes"));
  options = {};
  options.budgets.memory_bytes = 1 << 20;
  EXPECT_THAT(said("#declare A=array[1e6];", options),
              HasSubstr("raise the limit with --max-scene-bytes"));
  options = {};
  options.budgets.seconds = 1e-9;
  EXPECT_THAT(said("#for(I,1,1e5) #declare A=I; #end", options),
              HasSubstr("raise the limit with --max-read-seconds"));
}

TEST(LanguageBudgets, MessagesOfEveryKindAreCounted) {
  LoadOptions options;
  options.budgets.written_bytes = 100'000;
  for (const char* message : {"#debug \"\"", "#warning \"\"", "#render \"x\"",
                              "#declare deprecated \"old\" A=1; #declare B=A;"}) {
    const std::string program = std::string("#for(I,1,1e9) ") + message + " #end";
    EXPECT_THAT(said(program, options), HasSubstr("raise the limit with --max-written-bytes"))
        << message;
  }
}

TEST(LanguageBudgets, ArraysThatComeAndGoAreNotAddedUp) {
  LoadOptions options;
  options.budgets.array_elements = 1000;
  EXPECT_EQ(said("#macro M() #local A=array[1000]; #end #for(I,1,50) M() #end", options), "");
}

TEST(Language, LongLoopsWithoutABodyOnlyCount) {
  EXPECT_EQ(said("#for(I,1,1e7) #end #debug str(I,0,0)"), "10000001");
}

}  // namespace
}  // namespace dioptre::pov
