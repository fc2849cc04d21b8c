// superellipsoid: boxy, round, cylindrical, pinched; turned, in CSG.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -8> right 4/3*x look_at <0, .3, 0> angle 45 }
light_source { <-4, 7, -8>, rgb 1 }
background { rgb <.2, .25, .2> }
superellipsoid { <.1, .1> pigment { rgb <.9, .5, .2> } rotate <20, 30, 0>
    translate <-2.5, 1, 1.2> }
superellipsoid { <1, .2> pigment { rgb <.3, .8, .7> } rotate 90*x
    translate <0, 1, 1.4> }
superellipsoid { <.4, 1.5> pigment { rgb <.6, .5, .95> } rotate -60*x
    translate <2.4, 1, 1> }
superellipsoid { <2.6, 3> pigment { rgb .8 } rotate <30, 20, 0>
    translate <-2.2, .9, -1.4> }
difference { superellipsoid { <1.7, .6> }
    superellipsoid { <.3, .3> scale .7 translate <.6, .6, -.6> }
    pigment { rgb <.9, .3, .4> } translate <0, .8, -1.4> }
superellipsoid { <.02, 1.2> pigment { rgb <.3, .5, .9> } finish { phong .7 }
    rotate 50*y scale <1, .6, 1> translate <2.3, .6, -1.4> }
plane { y, -.2 pigment { checker rgb .8, rgb .5 } }
