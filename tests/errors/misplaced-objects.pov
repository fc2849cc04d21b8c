#version 3.7;
global_settings { assumed_gamma 1 }
#declare Ball = sphere { 0, 1 }
mesh { triangle { 0, x, y } sphere { 0, 1 } }
blob { threshold .5 box { 0, 1 } }
blob { threshold .5 sphere { 0, 1, 1 } Ball }
object { Ball() }
#declare My Ball = sphere { 0, 1 }
#local My sphere = 3;
#declare Box = { box { 0, 1 } }
object { Box }
