#declare A = array[3] mixed { 1, <1, 2, 3>, "a" };
sphere { 0, A[0] }
#macro Ball(R, optional Shade)
  sphere { 0, R }
#end
Ball(1)
