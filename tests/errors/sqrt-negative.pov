#declare A = sqrt(-1);
