// Where a perspective ray goes: angle 60 with right 4/3 and up 1 on 64 x 48.
// claims: rays path mesh soft
//
// |direction| = .5 * (4/3)/tan 30 = 1.154701. The wall z = 5 is met at
// x = 5 * ((i + .5)/64 - .5) * 1.333333/1.154701 = ((i + .5)/64 - .5) * 5.773503
// and y = (.5 - (j + .5)/48) * 5/1.154701 = (.5 - (j + .5)/48) * 4.330127.
// It glows (x + 4)/8 above y = 0 and (y + 4)/8 below.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 right 4/3*x up y angle 60 look_at z }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare Map = color_map { [0 rgb 0] [1 rgb 1] };
box { <-4, 0, 5>, <4, 4, 6>
    pigment { gradient x color_map { Map } scale 8 translate -4*x } }
box { <-4, -4, 5>, <4, 0, 6>
    pigment { gradient y color_map { Map } scale 8 translate -4*y } }
