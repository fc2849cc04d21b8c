// Of isosurfaces in CSG and clipped, POV-Ray sees as many crossings of a ray as
// max_trace says; where rays have entered the container they don't meet it again.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 42 }
light_source { <3, 5, -9> rgb 1 }
#declare Texture = texture { pigment { rgb <1, .5, .3> } finish { ambient .3 } }
#macro Words (Most)
  #if (Most = 0) all_intersections #end
  #if (Most > 1) max_trace Most #end
#end
#macro Shell (Most)
  isosurface {
    function { abs(sqrt(x*x + y*y + z*z) - 1) - .1 } contained_by { box { -1.2, 1.2 } }
    Words(Most) texture { Texture }
  }
#end
#macro Cut (Most)
  isosurface {
    function { sqrt(x*x + y*y + z*z) - 1.25 } contained_by { box { -1, 1 } }
    Words(Most) texture { Texture }
  }
#end
#macro Layer (Turn)
  isosurface {
    function { -z + .1*x } max_gradient 1.1 max_trace 3
    clipped_by { plane { z, .5 inverse } } texture { Texture }
    scale .3 rotate Turn*y
  }
#end
#macro Row (Most, X)
  difference { Shell(Most) plane { z, -.3 } scale .4 translate <X, 1.4, 0> }
  object { Shell(Most) clipped_by { plane { z, -.3 inverse } } scale .4 translate <X, .45, 0> }
  difference { Cut(Most) sphere { -z, .9 } scale .4 rotate 20*y translate <X, -.5, 0> }
  object { Cut(Most) clipped_by { plane { z, -.3 inverse } } scale .4 rotate 20*y
    translate <X, -1.4, 0> }
#end
Row(1, -1.5)
Row(2, -.5)
Row(3, .5)
Row(0, 1.5)
object { Layer(20) translate <2.4, 0, 0> }
object { Layer(200) translate <-2.4, 0, 0> }
