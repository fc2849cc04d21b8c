// height_field: heights of 16 bits that differ by a few units only, none of
// which is rounded; flat and smooth.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -5> look_at <0, 0, -.2> angle 30 right 4/3*x }
light_source { <6, 9, -4> rgb 1 }
#declare Low = transform {
    translate <-.5, -30000/65536, -.5> scale <1.5, 65536/16, 2>
}
height_field { png "parts/heights16_low.png" transform Low
    pigment { rgb 1 } translate -.8*x }
height_field { png "parts/heights16_low.png" smooth transform Low
    pigment { rgb 1 } translate .8*x }
