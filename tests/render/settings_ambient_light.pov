// ambient_light multiplies ambient and not emission; colours above 1 and
// below 0 are kept until the end.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb <3, 1, .5> }
camera { location <0, 2, -7> right 4/3*x look_at <0, .7, 0> angle 45 }
light_source { <-4, 8, -6>, rgb <1.8, 1.5, -.3> }
background { rgb <.1, .2, .4> }
sphere { <-2, .8, 0>, .8 pigment { rgb .6 } finish { ambient .3 } }
sphere { <0, .8, 0>, .8 pigment { rgb .6 } finish { ambient 0 emission .3 } }
sphere { <2, .8, 0>, .8 pigment { rgb <.6, 2, .5> } finish { ambient rgb <.1, .2, 1.5> } }
plane { y, 0 pigment { rgb .5 } finish { reflection .3 } }
