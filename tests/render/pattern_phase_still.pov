// Patterns whose frequency is 0 until one is said, so that there is no phase:
// quilted and image_pattern, and what takes the place of these and of lists.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
light_source { <-5, 8, -15> 1 }
#declare Colours = color_map { [0 rgb x] [.5 rgb y] [1 rgb z] }
#declare Picture = pigment {
    image_pattern { png "parts/colour16.png" interpolate 2 } color_map { Colours }
}
#declare Quilted = pigment { quilted color_map { Colours } }
#declare Checker = pigment { checker rgb x rgb y }
#default { finish { ambient .5 } }
box { -.9, .9 pigment { Picture phase .3 } rotate 20 translate <-2.6, 1.3, 0> }
box { -.9, .9 pigment { Quilted phase .3 } rotate 20 translate y*1.3 }
box { -.9, .9 pigment { Quilted phase .3 frequency 1 } rotate 20 translate <2.6, 1.3, 0> }
box { -.9, .9 pigment { Quilted wood phase .3 } rotate 20 translate <-2.6, -1.3, 0> }
box { -.9, .9 pigment { Checker wood color_map { Colours } phase .3 } rotate 20 translate -y*1.3 }
box { -.9, .9 pigment { Picture triangle_wave phase .3 } rotate 20 translate <2.6, -1.3, 0> }
