// Interior fading with a power below 1000: T = 1/(1 + (d/D)^P), and the light
// becomes T + (1 - T) * fade_color of what it was.
// claims: rays mesh soft
//
// Slabs 3 thick before a wall that glows 1; D = 2, fade_color <0, .5, .9>.
//   P = 1: T = 1/2.5 = .4: <.4, .7, .94>
//   P = 2: T = 1/3.25 = .307692: <.307692, .653846, .930769>
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
plane { -z, -5 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }
#default { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
box { <-3, -2, 0>, <-.5, 2, 3>
    interior { fade_distance 2 fade_power 1 fade_color <0, .5, .9> } }
box { <.5, -2, 0>, <3, 2, 3>
    interior { fade_distance 2 fade_power 2 fade_color <0, .5, .9> } }
