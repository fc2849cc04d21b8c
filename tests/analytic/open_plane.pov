// A plane under the open sky has exactly its ambient term beside what a lamp
// gives it, pigment p = <.8, .5, .4>: sun from 45 degrees, of light <1, .9, .8>,
// through 0.6 of diffuse, p (.2 <1, .5, 2> + .6 cos 45 <1, .9, .8>) =
// <.499411, .240919, .295765>.
// claims: rays mesh path
// options mesh: --mesh-indirect on
#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb <1, .5, 2> }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
light_source { <-1000, 0, -1000> rgb <1, .9, .8> parallel point_at 0 }
plane { -z, 0 pigment { rgb <.8, .5, .4> } finish { ambient .2 diffuse .6 } }
