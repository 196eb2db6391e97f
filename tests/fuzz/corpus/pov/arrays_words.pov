#declare A = array[2][3] { { 1, 2, 3 }, { x, "s", array[1] { 0 } } };
#declare B = A; #declare B[0][1] = A[1][0];
#debug str(dimension_size(A, 2) + dimensions(A), 0, 2)
#ifdef (A[1][2]) #undef A #end
#macro Swap(P, Q) #local T = P; #declare P = Q; #declare Q = T; #end
Swap(B[0][0], B[0][1])
