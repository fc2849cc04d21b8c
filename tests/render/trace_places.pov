// What trace() finds of an isosurface: the end of the last halving of its ray, a
// tenth below the surface here. Further away than 10,000,000 it finds nothing.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -5> angle 40 look_at 0 }
light_source { <-20, 50, -30> rgb 1 }
#declare Land = isosurface {
  function { y - .2*sin(x*3)*cos(z*2) } accuracy .2 max_gradient 1.3
  contained_by { box { <-1.5, -1, -1.5>, <1.5, 1.3, 1.5> } } }
#declare I = 0;
#while (I < 15)
  #declare J = 0;
  #while (J < 15)
    sphere { trace(Land, <I - 7, 50, J - 7>/5*<1, 1, 1>, -y), .09
      pigment { rgb <I/15, J/15, 1> } }
    #declare J = J + 1;
  #end
  #declare I = I + 1;
#end
#declare N = y;
#declare Ground = plane { y, 0 }
#declare P = trace(Ground, y, <0, -1e-12, 1>, N);
sphere { <1.7, 0, 0>, .2 + .2*vlength(N) pigment { rgb y } }
