// ripples and waves as normals and as pigments, with frequency and phase, on
// many tiles, since a single one depends on a few random centres; and a
// normal seen in a reflection.
// compare: exact
// options: +W320 +H240
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <-60, 80, -100>, rgb 1 parallel point_at 0 }
background { rgb <.3, .4, .7> }
#default { pigment { rgb <.7, .75, .8> } finish { ambient 0 diffuse 1 } }
#declare Map = color_map {
    [0 rgb <.2, .3, .5>] [.5 rgb <.8, .9, .9>] [1 rgb <.2, .3, .5>] }
#declare R = 0;
#while (R < 8)
    #declare C = 0;
    #while (C < 16)
        #declare Turn = transform {
            rotate <37*R, 91*C, 53*(C + R)> translate <-30, 20, 40> scale .08 }
        box { 0, <.25, .25, .1>
            #switch (int(R/4)*2 + int(C/8))
            #case (0) normal { ripples 1.5 transform Turn } #break
            #case (1) normal { waves 1.5 frequency 2 transform Turn } #break
            #case (2) pigment { ripples color_map { Map } phase .1
                transform Turn } #break
            #else pigment { waves color_map { Map } frequency 2 transform Turn }
            #end
            translate <.25*C - 2, 1.25 - .25*R, 0> }
        #declare C = C + 1;
    #end
    #declare R = R + 1;
#end
box { <-2, -1.5, 0>, <2, -.5, .1> normal { bumps .4 scale .04 }
    pigment { rgb .1 } finish { reflection .7 } }
plane { z, -20 pigment { gradient y color_map {
    [0 rgb <.9, .4, .2>] [1 rgb <.2, .8, .5>] } scale 6 }
    finish { ambient 1 } no_shadow }
