// gradient with every waveform: ramp, triangle, sine, scallop, cubic, poly
// with two exponents, and frequency and phase with it.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <0, 0, -100>, rgb 1 parallel point_at 0 }
#default { finish { ambient 0 diffuse 1 } }
#declare Map = color_map { [0 rgb <.1, .1, .5>] [.5 rgb <.9, .4, .2>] [1 rgb 1] }
#macro Strip(Row, P)
    box { <-2, -.2, 0>, <2, .2, .1> pigment { P } translate (1.26 - .42*Row)*y }
#end
Strip(0, pigment { gradient x color_map { Map } ramp_wave })
Strip(1, pigment { gradient x color_map { Map } triangle_wave })
Strip(2, pigment { gradient x color_map { Map } sine_wave frequency 2 })
Strip(3, pigment { gradient x color_map { Map } scallop_wave phase .25 })
Strip(4, pigment { gradient x color_map { Map } cubic_wave })
Strip(5, pigment { gradient x color_map { Map } poly_wave .4 frequency -1.5 })
Strip(6, pigment { gradient x color_map { Map } poly_wave 3 phase .6 })
