#version 3.7; global_settings { assumed_gamma 1 }
sphere { <0, 1, 0>, 2 sturm hierarchy off split_union on no_radiosity }
box { -1, <1, 2, 3> inverse hollow on double_illuminate }
plane { <0, 1, 0>, -2 no_shadow no_image no_reflection }
cylinder { -y, y, 0.5 open }
cone { 0, 1, 2*y, 0.2 open }
torus { 1, 0.25 sturm rotate 90*x }
disc { 0, z, 1, 0.5 }
triangle { 0, x, y texture { pigment { rgb 1 } } }
smooth_triangle { 0, -z, x, -z, y, <0.1, 0, -1> }
polygon { 5, 0, x, x + y, y, 0 }
quadric { <1, 1, 1>, <0, 0, 0>, <0, 0, 0>, -1 }
cubic { <1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, -1> sturm }
quartic { <1, 0, 0, 0, 2, 0, 0, 2, 0, -10.4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    1, 0, 0, 2, 0, 10.4, 0, 0, 0, 0, 1, 0, 0, 0, 22> }
poly { 2, <1, 0, 0, 0, 1, 0, 0, 1, 0, -1> }
difference { box { -1, 1 } sphere { 0, 1.2 } }
merge { sphere { 0, 1 } sphere { x, 1 } interior { ior 1.3 } }
intersection { plane { x, 1 } box { -1, 1 } clipped_by { plane { y, 0 } }
    bounded_by { clipped_by } photons { target 1 } radiosity { importance 1 } }
#declare Part = union { sphere { 0, 1 } object { box { 0, 1 } } }
object { Part scale <1, -2, 3> bounded_by { sphere { 0, 9 } }
    transform { rotate x inverse } material { texture { pigment { rgb 1 } } } }
