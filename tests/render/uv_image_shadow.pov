// What an image by uv_mapping lets pass is seen, but as POV-Ray has it not in
// shadows when image and uv_mapping stand in the pigment of a whole object;
// around the pigment, before its name or in a map it is.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -8> right 4/3*x look_at <0, 0, .2> angle 40 }
light_source { <0, 20, 4> rgb 1 }
plane { y, -1 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
#declare Glass = pigment { image_map { function 8, 8 { pattern { checker scale .25 } } filter all .6 } }
#declare Own = pigment { uv_mapping image_map { function 8, 8 { pattern { checker scale .25 } } filter all .6 } }
#declare Mapped = pigment { uv_mapping image_map { function 8, 8 { pattern { checker scale .25 } } filter all .6 } }
#declare Pane = box { <-.5, 0, -.3>, <.5, .05, .3> }
object { Pane pigment { Own } translate <-2, 0, 1.4> }
object { Pane texture { uv_mapping pigment { Glass } } translate <0, 0, 1.4> }
object { Pane pigment { uv_mapping checker rgbf <1, 0, 0, .7> rgbf <0, 0, 1, .7> } translate <2, 0, 1.4> }
object { Pane pigment { checker pigment { Mapped } pigment { Mapped } } translate <-2, 0, 0> }
object { Pane texture { pigment { rgbf 1 } } texture { Own } translate 0 }
object { Pane pigment { uv_mapping Glass } translate <2, 0, 0> }
mesh {
    triangle { <-.6, 0, -.3>, <.6, 0, -.3>, <0, 0, .3> uv_vectors <0, 0>, <1, 0>, <.5, 1> }
    texture { Own } translate <-1, 0, -1.4>
}
mesh {
    triangle { <-.6, 0, -.3>, <.6, 0, -.3>, <0, 0, .3> uv_vectors <0, 0>, <1, 0>, <.5, 1> texture { Own } }
    translate <1, 0, -1.4>
}
