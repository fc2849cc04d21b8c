// Spelling that is allowed and met in the wild: commas left out, colour and
// color, red green blue, scalars for vectors, numbers like .5 and 1., a scale
// by 0, comments in comments, keywords stuck to numbers.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1. }
/* a comment /* inside another */ still the first */
camera { location <0 3 (-8)> right<4/3,0,0> look_at <0 .8 0> angle 42 }
light_source { <-5 9 (-6)> color 1 }
background { colour red .4 green .5 blue .7 }
sphere { <-2.5 .8 0> .8 pigment { color red .9 green .4 } finish { ambient.2diffuse.7 } }
box { <-1 0 0>+<0,.01,0> <0 1 1> pigment { colour rgb<.3,.8,.4> } }
sphere { 0 1 scale 2*y + <.5, -1.4, .5> translate 1.2*x + .61*y
    pigment{rgb<.9,.8,.2>}finish{phong 1}}
#declare Gap = +.5; #declare Wide = 2.e0;
union { sphere { 0, .4 } sphere { Gap, .4 }
    scale Wide/2 rotate 30 translate Wide + <.2, -1.5, -.4>
    pigment { rgb 1/2 } }
plane { y (-.01) pigment { rgb .6 } }
