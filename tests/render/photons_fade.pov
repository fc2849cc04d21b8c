// Photons in coloured glass that mirrors: what lands in it, is mirrored there or
// leaves it has been weakened on its way; without a fade_power photons don't
// fade.
// compare: noise
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 photons { count 60000 } }
camera { location <0, 2, -9> right 4/3*x look_at <0, 1, 0> angle 26 }
light_source { <2, 9, 8>, rgb 1.5 photons { refraction on reflection on } }
#default { finish { ambient .05 diffuse .6 } }
#macro Body(X, Power)
  sphere { <X, 1, 0>, .9
    pigment { rgbf <.98, .98, .98, .8> }
    finish { reflection .5 }
    interior { ior 1.5
      fade_color <.9, .2, .1> fade_distance .4 fade_power Power }
    photons { target refraction on reflection on } }
#end
Body(-1, 1001)
Body(1, 0)
plane { y, 0 pigment { rgb .9 } }
