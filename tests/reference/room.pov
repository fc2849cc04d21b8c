// A closed room with two blocks, for comparison with other programs: diffuse
// alone, one point light that fades with the square of distance (fade_distance
// 0.01 is as good as none: 2 (D/d)^2 of 6000 is 1.2/d^2). tests/reference/run
// makes the same room for Embree's path tracer.
#version 3.7;
global_settings {
  assumed_gamma 1
  radiosity { count 400 error_bound 0.5 recursion_limit 4 }
}
#default { finish { ambient 0 diffuse 0.5 } }
camera { location <0, 1.5, -2.9> look_at <0, 1.5, 0> right 4/3*x up y angle 73.7398 }
light_source { <0, 1.6, -0.8>, 6000 fade_distance 0.01 fade_power 2 }
box { <-2.2, -0.2, -3.2>, <2.2, 0, 2.2> pigment { rgb 1 } }
box { <-2.2, 3, -3.2>, <2.2, 3.2, 2.2> pigment { rgb 1 } }
box { <-2.2, 0, 2>, <2.2, 3, 2.2> pigment { rgb 1 } }
box { <-2.2, 0, -3.2>, <2.2, 3, -3> pigment { rgb 1 } }
box { <-2.2, 0, -3>, <-2, 3, 2> pigment { rgb <1, 0.16, 0.10> } }
box { <2, 0, -3>, <2.2, 3, 2> pigment { rgb <0.20, 0.80, 0.16> } }
box { <-0.6, 0, -0.6>, <0.6, 1.7, 0.6>
  rotate 20*y translate <-0.8, 0, 0.9> pigment { rgb 1 } }
box { <-0.5, 0, -0.5>, <0.5, 0.9, 0.5>
  rotate -25*y translate <0.8, 0, -0.5> pigment { rgb <0.9, 0.8, 0.5> } }
