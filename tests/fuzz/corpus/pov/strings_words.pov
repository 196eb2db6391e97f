#declare S = concat("a\u00e4", str(pi, 8, 3), vstr(3, <1, 2, 3>, ", ", 0, 1), chr(65));
#if (strcmp(strupr(S), strlwr(S)) = strlen(S) | asc(S) != val("1e3")) #debug substr(S, 1, 2) #end
#debug datetime(3.5, "%Y")
