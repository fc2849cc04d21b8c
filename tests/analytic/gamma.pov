// assumed_gamma 2.2: light is added in the scene's own space and leaves it by
// the power of 2.2 when a linear file is written.
// claims: rays path mesh soft many
//
// Two parallel lights of .3, head on: .6^2.2 = .325037. The glowing box: pigment
// .5 by emission .8: .4^2.2 = .133209. A background of <.9, .2, .05>: .793110,
// .028991, .001373.
#version 3.7;
global_settings { assumed_gamma 2.2 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
background { rgb <.9, .2, .05> }
light_source { <0, 0, -20>, rgb .3 parallel point_at 0 }
light_source { <0, 0, -30>, rgb .3 parallel point_at 0 }
box { <-3, -2, 0>, <-.5, 2, 1> pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
box { <.5, -2, 0>, <3, 2, 1> pigment { rgb .5 }
    finish { ambient 0 diffuse 0 emission .8 } }
