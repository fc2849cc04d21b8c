#declare A = array[3];
#declare B = A[1] + 1;
