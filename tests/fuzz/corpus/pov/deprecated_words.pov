#declare deprecated once "old" A = 1; #local deprecated B = A + A; #declare sphere = 5; #declare C = sphere
/* a /* nested */ comment */ // end
#declare F = 3;
