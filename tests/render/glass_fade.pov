// interior fade_distance, fade_power and fade_color weaken light inside glass;
// material{} bundles texture and interior; a shadow through glass.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 2.5, -8> right 4/3*x look_at <0, .5, 0> angle 40 }
light_source { <-4, 8, -6>, rgb 1 }
background { rgb <.7, .8, .9> }
plane { y, -.42 pigment { checker rgb <.9, .7, .5>, rgb .95 translate .27 } }
#declare Fading = material {
    texture { pigment { rgbt <1, 1, 1, 1> } finish { ambient 0 diffuse 0 phong .5 } }
    interior { ior 1.2 fade_distance .6 fade_power 2 fade_color <.2, .5, .8> }
}
sphere { <-2.2, .5, 0>, .85 material { Fading } }
box { -.6, .6 rotate 40*y translate <-.2, .25, .2>
    material { texture { pigment { rgbf 1 } finish { ambient 0 diffuse 0 } }
        interior { ior 1 fade_distance .5 fade_power 1 } } }
cylinder { <1.4, .2, .6>, <2.6, .9, -.6>, .5
    material { Fading } interior { ior 1 fade_distance .3 fade_power 1001
        fade_colour <.9, .4, .1> } }
