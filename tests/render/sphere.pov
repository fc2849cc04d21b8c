// Spheres: overlapping, inside one another, scaled unevenly and mirrored.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> right 4/3*x look_at <0, .2, 0> angle 50 }
light_source { <-6, 9, -8>, rgb 1 }
background { rgb <.1, .15, .25> }
sphere { <-2, 0, 0>, 1.1 pigment { rgb <.9, .3, .2> } }
sphere { <-1.2, .4, -.6>, .7 pigment { rgb <.9, .8, .2> } }
sphere { 0, 1 scale <.5, 1.4, .5> rotate 25*z translate <.6, .3, .2>
    pigment { rgb <.2, .7, .4> } }
sphere { <0, 0, 0> 1 scale <-1, .4, 1> rotate <20, 0, -30>
    translate <2.3, 0, 0> pigment { rgb <.4, .5, .95> } }
sphere { <0, -1001.2, 0>, 1000 pigment { rgb .7 } }
