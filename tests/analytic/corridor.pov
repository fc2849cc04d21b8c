// A corridor of mirrors, with a wall at its end that glows.
// claims: path
// options path: --samples 16384
//
// Between the mirrors x = -1 and x = 1, which reflect R = .8, the glowing wall
// z = 5 is seen again and again: the strip that is k mirrors away lies from
// 2k - 1 to 2k + 1 and is weakened to R^|k|. An endless strip between angles s
// and t from the normal has the form factor (sin t - sin s)/2, so at (x, 0, 0),
//   E = sum over k of .8^|k| (f(2k + 1 - x) - f(2k - 1 - x))/2,
// f(u) = u/sqrt(u^2 + 25): x = 0: .679028, x = .5: .677230; 20 from the wall,
// x = 0: .344072.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 200 }
camera { location 0 }
plane { x, -1 pigment { rgb 1 } finish { ambient 0 diffuse 0 reflection .8 } }
plane { -x, -1 pigment { rgb 1 } finish { ambient 0 diffuse 0 reflection .8 } }
plane { -z, -5 pigment { rgb <1, .5, .1> }
  finish { ambient 0 diffuse 0 emission 1 } }
