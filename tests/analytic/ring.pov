// The floor in the shade of a ring that lies on it.
// claims: path bounced
// options path: --samples 1024
//
// What is met in a crevice is lit by further rays. Where few of these go on by
// chance, in place of what is usual outside, some places get less than nothing:
// black specks along the ring. The values are a path tracer's.
#version 3.7;
global_settings { assumed_gamma 1 }
camera {
  location <0, 200, -600> look_at 50*y angle 40
  right 4/3*x
}
light_source { <500, 500, -500>, rgb 1 }
#default { finish { ambient .1 } }
plane { y, -1 pigment { rgb y } }
sphere { 100*y, 100 pigment { rgb x } }
torus { 150, 15 pigment { rgb 1 } translate 20*y finish { ambient .3 } }
