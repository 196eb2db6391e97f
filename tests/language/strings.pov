// SPDX-License-Identifier: Apache-2.0
// Strings.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Show(Text) #debug concat("= [", Text, "]\n") #end
// -- literals
Show("plain") Show("a\\b") Show("a\"b") Show("a\tb") Show("it\'s") Show("") Show("\u0041")
// -- concat
Show(concat("a","b","c")) Show(concat("a")) #declare S = "text"; Show(concat(S," ",S))
// -- chr
Show(chr(65)) Show(concat(chr(97),chr(98)))
// -- str
Show(str(123.456,0,3)) Show(str(123.456,9,3)) Show(str(123.456,-9,3)) Show(str(-1.5,8,1)) Show(str(2,0,0))
Show(str(123.456,0,-1)) Show(str(1e20,0,2)) Show(str(1e-5,0,8)) Show(str(.5,0,0)) Show(str(1.5,0,0)) Show(str(2.5,0,0))
Show(str(-0.0001,0,2)) Show(str(1/3,0,15))
// -- vstr
Show(vstr(2,<1,2>,", ",0,1)) Show(vstr(5,<1,2,3,4,5>,", ",0,1)) Show(vstr(1,1,", ",0,1)) Show(vstr(7,1,", ",0,1))
Show(vstr(3,<1,2>,", ",0,1)) Show(vstr(5,<1,2,3>,"; ",6,2)) Show(vstr(3,<1,2,3>,"-",-6,2))
// -- substr
Show(substr("ABCDEFGHI",4,2)) Show(substr("ABC",1,3)) Show(substr("ABC",3,1))
// -- case
Show(strlwr("Hello There!")) Show(strupr("Hello There!"))
// -- input file name
#debug concat("= ", str((strlen(input_file_name) > 0), 0, 0), "\n")
// -- datetime
Show(datetime(0)) Show(datetime(0,"%Y-%m-%d")) Show(datetime(365.5,"%d.%m. %H:%M")) #declare Now = now; Show(str((Now>5000),0,0))
// -- str of values
#declare A = array[2]; #declare A[0] = "zero"; #declare A[1] = concat(A[0], "one"); Show(A[1])
// -- substr beyond the end (fails)
Show(substr("ABC",2,5))
// -- str of text (fails)
Show(str("a",0,0))
// -- long
#declare L = "0123456789"; #declare L = concat(L,L,L,L,L,L,L,L,L,L); #declare L = concat(L,L,L,L,L,L);
#debug concat("= ", str(strlen(L),0,0), "\n")
