// A corner with a glowing panel, a ball and a lamp: every kind of estimate that
// path makes, small enough to be drawn often.
#version 3.7;
global_settings { assumed_gamma 1 light_mesh { sky on } }
#default { finish { ambient 0 diffuse .7 } }
camera { location <1.6, 1.8, -3.2> look_at <-.1, .6, 0> right 4/3*x angle 50 }
background { rgb <.05, .08, .12> }
light_source { <2, 3, -3>, rgb .5 }
plane { y, 0 pigment { rgb .8 } }
plane { x, -1.4 pigment { rgb <.9, .3, .2> } }
plane { -z, -1.4 pigment { rgb <.3, .6, .8> } }
box { <-.6, 1.9, -.6>, <.6, 1.95, .6>
    pigment { rgb <1, .9, .7> } finish { diffuse 0 emission 3 } }
sphere { <-.2, .5, .2>, .5 pigment { rgb .6 }
    finish { specular .4 roughness .05 reflection .2 } }
sphere { <.7, .25, -.5>, .25 pigment { rgbt .9 }
    finish { diffuse .1 reflection { 0, 1 fresnel } } interior { ior 1.3 } }
