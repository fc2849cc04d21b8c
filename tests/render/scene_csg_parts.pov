// CSG of inverse, clipped, cut away and bounded parts.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> look_at 0 angle 42 }
light_source { <-6, 8, -6> rgb 1 }
#declare A = difference { sphere { 0, 1 } plane { -x, 0 inverse } cutaway_textures pigment { rgb <.9,.4,.2> } }
object { A rotate y*30 translate -x*2.2 }
union { object { A inverse clipped_by { box { -1.1, 1.1 } } } split_union off translate x*2.2 }
merge { sphere { -x*0.5, 0.8 } sphere { x*0.5, 0.8 } cylinder { -x*1.5, x*1.5, 0.2 } pigment { rgbt <.4,.6,.9,.5> } interior { ior 1.1 } clipped_by { plane { -z, 0.4 } } bounded_by { clipped_by } translate y*1.2 }
intersection { box { -0.7, 0.7 rotate 45 } sphere { 0, 0.9 } torus { 0.9, 0.35 inverse } pigment { checker rgb .9 rgb <.3,.5,.3> scale 0.3 } finish { specular 0.5 } translate -y*0.8 }
difference { object { difference { box { -1, 1 } sphere { 0, 1.2 } } } plane { y, 0 } scale 0.6 pigment { onion scale 0.2 } translate <0.2,-1.1,-2> }
plane { y, -1.5 pigment { rgb 0.8 } }
