// Two endless plates face to face, and a lamp of the other's group.
// claims: path bounced
// options path: --samples 16384
//
// Both lamps shine on A, through B, which throws no shadow, and on B's back. The
// second is B's alone: A has E of the first, <.4, .3, .2>, and what B sends back.
// LA = a (E + LB), LB = b LA: LA = a E/(1 - a b) with a = <.5, .8, .2>,
// b = <.4, .6, .9>. B has LA.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location z }
light_source { 9*z, rgb <.4, .3, .2> parallel point_at 0 }
plane { z, 0 pigment { rgb <.5, .8, .2> } finish { ambient 0 diffuse 1 } }
light_group {
  light_source { 9*z, rgb <.2, .4, .9> parallel point_at 0 }
  plane { -z, -2 pigment { rgb <.4, .6, .9> } finish { ambient 0 diffuse 1 }
    no_shadow }
  global_lights on
}
