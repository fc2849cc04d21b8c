// Photons: a glass ball, a lens and a ring of metal gather light on a floor,
// one lamp fades; a mirror throws some on to a wall.
// compare: noise
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 photons { count 150000 } }
camera { location <0, 4, -7> right 4/3*x look_at <0, .6, .5> angle 45 }
light_source { <-4, 7, -3>, rgb .9 photons { refraction on reflection on } }
light_source { <5, 6, -2>, rgb <.3, .4, .8> fade_distance 6 fade_power 2
    photons { refraction on reflection on } }
#default { finish { ambient .05 diffuse .7 } }
plane { y, 0 pigment { checker rgb .8, rgb .6 } }
plane { -z, -4 pigment { rgb <.8, .7, .6> } }
sphere { <-1.2, .9, 0>, .8 pigment { rgbf <.9, 1, .9, .95> }
    finish { diffuse 0 reflection { 0, 1 fresnel } conserve_energy }
    interior { ior 1.5 } photons { target refraction on reflection on } }
sphere { 0, .8 scale <1, .35, 1> translate <.7, 1.3, -1.2> pigment { rgbf 1 }
    finish { diffuse 0 } interior { ior 1.4 } photons { target refraction on } }
difference {
    cylinder { 0, .5*y, .9 } cylinder { -y, y, .8 }
    translate <1.6, 0, .8> pigment { rgb <.9, .6, .3> }
    finish { diffuse .2 reflection .7 } photons { target reflection on }
}
box { <-.9, 0, -.05>, <.9, 1.2, .05> rotate 50*y translate <-2.6, 0, 1.6>
    pigment { rgb .1 } finish { reflection .8 } photons { target reflection on } }
