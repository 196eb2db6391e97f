#switch (3) #case (1) #break #range (2, 4) #debug "in" #else #end
#for (I, 3, -3, -1.5) #if (I = 0) #break #elseif (I < 0) #warning "w" #else #debug str(I, 0, 0) #end #end
#local N = 0; #while (N < 3 & !0) #local N = N + (N > 1 ? 2 : 1); #end
#macro A(x1, y1) #local L = x1; (L*y1 + B(L)) #end #macro B(q) #if (q > 0) B(q - 1) #else 7 #end #end
sphere { A(2, 3)*x, 1 }
#version 3.5; #default { finish { ambient 0.1 } } #ifndef (Q) #declare Q = seed(3); #end #declare R = rand(Q);
