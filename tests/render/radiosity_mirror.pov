// radiosity: a mirror and what glows close to it: what near rays meet by way of
// the mirror glows near other places in turn.
// compare: noise
#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 100 recursion_limit 1 } }
#default { finish { ambient 0 } }
plane { y, 0 pigment { rgb .8 } }
cylinder { 0, y, .5 pigment { rgb .9 } finish { reflection .3 } }
sphere { y*1.4, .4 pigment { rgb .9 } finish { emission .7 } }
light_source { <12, 8, -3> rgb 1 }
camera { location <0, 1.5, -5.5> look_at y angle 50 }
