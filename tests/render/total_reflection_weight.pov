// Of light that is all sent back inside glass none is lost, but against
// adc_bailout it counts less: by what the surface would let pass.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 25 adc_bailout .15 }
camera { orthographic location <0, 0, -5> look_at 0 right 4*x up 3*y }
light_source { <-4, 6, -3>, rgb 1.3 }
#default { finish { ambient 0 diffuse 0 } }
plane { y, 3
  pigment { checker rgb 1, rgb <1, .4, .1> scale .25 } finish { emission 1 } }
plane { z, 9 pigment { rgb <.1, .2, .5> } finish { emission 1 } }
plane { y, -3 pigment { rgb <.1, .5, .2> } finish { emission 1 } }
#macro Prism(X, Size, Pigment, Finish)
  prism { linear_sweep -1, 1, 4, <0, 0>, <2, 0>, <0, 2>, <0, 0>
    rotate 90*z translate <0, -1, -1> scale Size translate X*x
    pigment { Pigment } finish { Finish } interior { ior 1.5 } }
#end
Prism(-.3, .7, rgbf 1, finish { reflection { .5 } conserve_energy })
Prism(1.4, .7, rgbf <.5, .5, .5, 1>, finish { phong 0 })
