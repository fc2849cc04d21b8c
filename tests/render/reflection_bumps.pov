// Steep bumps in a mirror: normals that face away from the viewer, and those
// that face into the surface, under a sky whose colour is the direction.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Along(F, C) function { F(x, y, z) } color_map { [0 rgb 0] [1 rgb C] } #end
#declare Fx = function(x, y, z) { (x + 1)/2 }
#declare Fy = function(x, y, z) { (y + 1)/2 }
#declare Fz = function(x, y, z) { (z + 1)/2 }
sky_sphere { pigment { average pigment_map {
  [1 Along(Fx, <3, 0, 0>)] [1 Along(Fy, <0, 3, 0>)] [1 Along(Fz, <0, 0, 3>)] } } }
camera { location <0, 1, -14> right x*image_width/image_height angle 25 }
#declare Mirror = finish { ambient 0 diffuse 0 reflection 1 }
box { -1, 1 scale .75
  texture { pigment { rgb 0 } finish { Mirror }
            normal { hexagon 1.6 scale 0.124 rotate 90*x } }
  rotate <-30, 30, 0> translate <1.9, 1, 0> }
sphere { <-2, 1.5, 0>, 1 texture { pigment { rgb 0 } finish { Mirror }
  normal { gradient x 5 scale .4 } } }
cylinder { -z, z, .8 texture { pigment { rgb 0 } finish { Mirror }
  normal { granite 2.6 } } rotate <-20, 40, 0> translate -1.4*y }
