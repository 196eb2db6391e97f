// SPDX-License-Identifier: Apache-2.0
// Values and behaviour of the language; every expected text was printed by POV-Ray 3.7.0.10.
#include <gtest/gtest.h>

#include "dioptre/io/pov/language_test_support.h"

namespace dioptre::pov {
namespace {

struct Case {
  const char* program;
  const char* printed;
};

class Language : public ::testing::TestWithParam<Case> {};

TEST_P(Language, PrintsWhatPovRayPrints) {
  EXPECT_EQ(said(GetParam().program), GetParam().printed) << GetParam().program;
}

constexpr Case kNumbers[] = {
    {"#debug str((1=1+1e-11),0,0) #debug str((1=1+1e-10),0,0) #if(1e-11) #debug \"t\" #end", "10"},
    {"#debug str(((1|0)&0),0,0) #debug str((1|0&0),0,0) #debug str(!0+1,0,0)", "002"},
    {"#debug concat(str(mod(-7.5,2),0,2),\" \",str(div(-7,2),0,2),\" \",str(int(-2.5),0,2))",
     "-1.50 -3.00 -2.00"},
    {"#debug str(2.5,0,0) #debug str(pi,0,-1)", "23.141593"},
    {"#debug concat(\"[\",str(1,5,0),\"][\",str(1,-5,0),\"]\")", "[    1][00001]"},
    {"#declare A=-2; #debug str(abs(A)+-A,0,0) #debug str(2--1,0,0)", "43"},
    {"#debug str(5e-1,0,1) #debug str(.5e1,0,1) #debug str(5.,0,1)", "0.55.05.0"},
    {"#debug str(bitwise_and(7,3,2),0,0) #debug str(bitwise_xor(12,10),0,0)", "26"},
    {"#debug str(max(1,5,3),0,0) #debug str(min(4,2,3),0,0)", "52"},
    {"#debug str(select(-1,1,2,3)+select(0,1,2,3)*10+select(1,1,2)*100,0,0)", "221"},
    {"#declare Q = (1>2 ? 5 : 6); #debug str(Q,0,0)", "6"},
    {"#declare R=seed(1); #debug str(rand(R),0,15)", "0.421992875268215"},
    {"#declare R=seed(0); #debug str(rand(R),0,14)", "0.00000287429430"},
    {"#debug str(version,0,2) #debug str(image_width,0,0)", "3.70320"},
};
constexpr Case kVectors[] = {
    {"#declare V=<1,2,3>; #debug vstr(3,(V=<3,2,1>),\" \",0,0)", "0 1 0"},
    {"#debug vstr(5,<1,2>+<1,2,3>,\" \",0,0)", "2 4 3 0 0"},
    {"#debug vstr(5,x*2+t,\" \",0,0) #debug vstr(2,u+v,\" \",0,0)", "2 0 0 1 01 1"},
    {"#debug vstr(3,vrotate(x,90*y),\" \",0,3)", "0.000 0.000 -1.000"},
    {"#debug vstr(3,vcross(x,y),\" \",0,0) #debug str(vdot(x,<2,3,4>),0,0)", "0 0 12"},
    {"#macro Vec() <1,2,3> #end #declare Z=Vec().y; #debug str(Z,0,0)", "2"},
    {"#declare C=<.1,.2,.3>; #debug str(C.gray,0,4)", "0.1817"},
};
constexpr Case kColors[] = {
    {"#debug vstr(5,rgb 1-0.2,\" \",0,1)", "0.8 0.8 0.8 0.0 0.0"},
    {"#debug vstr(5,rgbt 1,\" \",0,0) #debug vstr(5,rgbf <1,2,3,4>,\" \",0,0)",
     "1 1 1 0 11 2 3 4 0"},
    {"#declare C=rgb <1,2,3> transmit 0.5; #debug vstr(5,C,\" \",0,1)", "1.0 2.0 3.0 0.0 0.5"},
    {"#declare C=color red 1 green 2; #declare D=color C red 0.5; #debug vstr(5,D,\" \",0,1)",
     "0.5 2.0 0.0 0.0 0.0"},
    {"#declare C=srgb 0.5; #debug vstr(5,C,\" \",0,6)",
     "0.214041 0.214041 0.214041 0.000000 0.000000"},
};
constexpr Case kStrings[] = {
    {"#debug substr(\"ABCDEFGHI\",4,2) #debug strupr(\"abC\") #debug chr(65)", "DEABCA"},
    {"#debug str(strlen(\"a\\nb\\\\\\\"\"),0,0) #debug \"a\\u0041b\"", "5aAb"},
    {"#debug str(strcmp(\"a\",\"b\"),0,0) #debug str(asc(\"A\"),0,0) #debug "
     "str(val(\"12.5x\"),0,1)",
     "-16512.5"},
    {"#if(strcmp(\"a\",\"b\")<0 & \"a\"=\"a\") #debug \"ok\" #end", "ok"},
};
constexpr Case kMacros[] = {
    {"#macro R(p) p*2 #end #debug str(R(1+2),0,0)", "6"},
    {"#declare P=5; #macro M(p) #declare p=p+1; #local q=3; #end M(P) #debug str(P,0,0) "
     "#ifdef(q) #debug \"q\" #end",
     "6"},
    {"#declare P=5; #macro M(p) #local p=p+1; #end M(P) #debug str(P,0,0)", "6"},
    {"#declare A=array[3]{1,2,3} #macro M(p) #declare p=p+10; #end M(A[1]) #debug str(A[1],0,0)",
     "12"},
    {"#macro F(A B) #debug \"f\" #end F(1,2)", "f"},
    {"#macro S(T) array[2] {T,T} #end #macro V(T) #local A=S(T); A[0]+A[1] #end "
     "#debug str(V(3),0,0)",
     "6"},
    {"#macro S(T) \"abc\" #end #macro V(T) #local A=S(T); strlen(A)+T #end #debug str(V(3),0,0)",
     "6"},
    {"#macro Q(n) #local k=n; #if(n>0) Q(n-1) #end #debug str(k,0,0) #end Q(4)", "01234"},
    {"#local L=1; #macro T() L #end #declare U=T(); #debug str(U,0,0)", "1"},
};
constexpr Case kControl[] = {
    {"#for(I,0,1,0.1) #debug \".\" #end #debug str(I,0,1)", "...........1.1"},
    {"#for(I,3,1,-1) #debug str(I,0,0) #end #debug str(I,0,0)", "3210"},
    {"#switch(2) #case(1) #debug \"1\" #case(2) #debug \"2\" #case(3) #debug \"3\" #else #debug "
     "\"e\" #end",
     "23e"},
    {"#switch(2) #case(2) #if(1) #debug \"2\" #break #end #debug \"n\" #else #debug \"e\" #end "
     "#debug \"z\"",
     "2z"},
    {"#switch(9) #case(1) #debug \"1\" #range(2,3) #debug \"r\" #else #debug \"e\" #end", "e"},
    {"#if(0) #debug \"a\" #elseif(1) #debug \"b\" #else #debug \"c\" #end", "b"},
    {"#declare I=0; #while(I<5) #if(I=3) #break #end #debug str(I,0,0) #declare I=I+1; #end",
     "012"},
    {"/* a /* b */ c */ #debug \"d\" // e", "d"},
};
constexpr Case kArrays[] = {
    {"#declare A=array[2][2]{{1,2},{3,4,},} #debug str(A[1][1.9],0,0) #debug "
     "str(dimension_size(A,2),0,0)",
     "42"},
    {"#declare A=array[2]; #declare A[0]=array[2]{1,2} #declare B=A; #declare B[0][1]=7; #debug "
     "concat(str(A[0][1],0,0),str(B[0][1],0,0))",
     "27"},
    {"#declare A=array[3] #declare A[1]=5; #ifdef(A[0]) #debug \"y\" #else #debug \"n\" #end", "n"},
};
constexpr Case kFunctions[] = {
    {"#declare f=function{(x=1)|0&0} #debug str(f(1,0,0),0,0)", "1"},
    {"#declare f=function(u,v){x+y*v} #debug str(f(2,3),0,0)", "11"},
    {"#declare f=function(n){prod(i,1,n,i)} #debug str(f(5),0,0)", "120"},
    {"#declare g=function(n,k){sum(i,1,n,i*k)} #debug str(g(4,2),0,0)", "20"},
    {"#declare f=function{select(x,-1,0,1)} #debug concat(str(f(-3,0,0),0,0),str(f(0,0,0),0,0))",
     "-10"},
    {"#declare f=function{-x*2} #declare h=function{f(x,y,z)+1} #undef f #debug str(h(2,0,0),0,0)",
     "-3"},
};
constexpr Case kSplines[] = {
    {"#declare S=spline{0,<1,2>,1,<3,5>} #debug vstr(3,S(.5),\" \",0,1)", "2.0 3.5 0.0"},
    {"#declare S=spline{cubic_spline 0,<1,2>,1,<3,5>,2,<0,0>,3,<5,5>} #debug vstr(2,S(1.5),\" "
     "\",0,6) #debug vstr(2,S(1.5,natural_spline),\" \",0,6) #debug "
     "vstr(2,S(1.5,quadratic_spline),\" \",0,3)",
     "1.312500 2.3750001.275000 2.3500002.125 3.500"},
    {"#declare S=spline{natural_spline 0,<0,0,0>,.5,<1,2,3>,1,<1,1,1>} #debug "
     "vstr(3,S(.25),\" \",0,3)",
     "0.594 1.281 1.969"},
};

INSTANTIATE_TEST_SUITE_P(Numbers, Language, ::testing::ValuesIn(kNumbers));
INSTANTIATE_TEST_SUITE_P(Vectors, Language, ::testing::ValuesIn(kVectors));
INSTANTIATE_TEST_SUITE_P(Colors, Language, ::testing::ValuesIn(kColors));
INSTANTIATE_TEST_SUITE_P(Strings, Language, ::testing::ValuesIn(kStrings));
INSTANTIATE_TEST_SUITE_P(Macros, Language, ::testing::ValuesIn(kMacros));
INSTANTIATE_TEST_SUITE_P(Control, Language, ::testing::ValuesIn(kControl));
INSTANTIATE_TEST_SUITE_P(Arrays, Language, ::testing::ValuesIn(kArrays));
INSTANTIATE_TEST_SUITE_P(Functions, Language, ::testing::ValuesIn(kFunctions));
INSTANTIATE_TEST_SUITE_P(Splines, Language, ::testing::ValuesIn(kSplines));

}  // namespace
}  // namespace dioptre::pov
