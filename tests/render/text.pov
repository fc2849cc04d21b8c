// text: the four fonts of POV-Ray, letters with holes and of two parts, pairs
// that stand closer, an offset, a bevel by CSG, thick and thin.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <3, 2.2, -9> right 4/3*x look_at <2.9, 1.4, 0> angle 45 }
light_source { <-4, 7, -8>, rgb 1 }
background { rgb <.2, .25, .2> }
text { ttf "timrom.ttf" "VAToj, gi&" 0.2, 0 pigment { rgb <.9, .5, .2> } }
text { ttf "cyrvetic", "Pack", 1, <.05, .03, .1>
    pigment { rgb <.3, .8, .7> } translate y }
text { ttf "crystal.ttf" concat("08", "%@") .4 0
    pigment { gradient y color_map { [.5 rgb <.6, .5, .95>] [.5 rgb .9] } }
    rotate -30*y translate <3.6, 1.2, 0> }
difference {
    box { <0, -.1, 0>, <2.4, 1, .3> }
    text { internal 2 "Sd8" .2 .05*x translate <.1, .1, -.1>
        pigment { rgb <.9, .2, .2> } }
    pigment { rgb .8 } translate 2.1*y
}
text { internal 0 "P" .3 0 pigment { rgb <.9, .8, .3> }
    scale 1.3 translate <3.4, 2.4, 0> }
plane { y, -.5 pigment { checker rgb .8, rgb .5 } }
