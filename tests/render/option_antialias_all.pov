// +A0.0: all pixels are sampled again, also where nothing differs yet, so that
// bars are seen that no pixel's middle meets.
// compare: exact
// options: +A0.0 +R2 -J
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -6> look_at 0 right 160*x up 120*y }
#default { finish { ambient 0 diffuse 0 emission 1 } }
sphere { 0, 20 pigment { rgb x } }
#for (I, -50, 50, 10)
    box { <-60, I - .4, 1>, <60, I + .4, 2> pigment { rgb <1, 1, .01 * I> } }
#end
