#version 3.7;
lathe { linear_spline <0,0>,<1,0>,<1,1> }
