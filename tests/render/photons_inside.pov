// Photons in glass with mirrors: none is doubled by total reflection, mirrors
// count twice for adc_bailout, and where photons are sparse they are no specks.
// compare: noise
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 15 photons { spacing .015 } }
camera { location <0, 4, -6> look_at <0, .6, 0> angle 42 }
light_source { <4, 9, 5> rgb 1.6 photons { reflection on refraction on } }
plane { y, 0 pigment { rgb <.8, .7, .6> } }
difference {
    lathe { linear_spline 7, <0, 0>, <.6, 0>, <.6, .05>, <.1, .1>, <.1, .9>, <.6, 1.2>, <.5, 2.1> }
    sphere { 0, .45 scale <1, 1.6, 1> translate <0, 1.75, 0> }
    pigment { rgbf <.97, .99, .98, .95> }
    finish { specular .8 roughness .001 reflection { .03, .9 fresnel on } conserve_energy ambient 0 diffuse 0 }
    interior { ior 1.5 fade_distance 1 fade_power 1001 fade_color <.8, .9, .85> }
    photons { target refraction on reflection on }
    translate <-1, .01, 0>
}
sphere { <1, .8, -.3>, .8 pigment { rgbf <1, .9, .8, 1> }
    finish { diffuse 0 reflection { .1, 1 fresnel } conserve_energy } interior { ior 1.6 }
    photons { target refraction on reflection on } }
