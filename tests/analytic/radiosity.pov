// radiosity {} under rays, in the manner of POV-Ray: a hollow ball that glows
// .1 and sends back the share .5 * <1, .5, .2> of what falls on it, twice, each
// time 1.5 times as bright and with half its colour gone.
// claims: rays
//
// e = <.1, .05, .02>; the brightness .589 g + .297 r + .114 b of light L is l(L);
// falling on the wall: F(L) = 1.5 (L + l(L))/2, sent back: e + .5 c F(L).
//   l(e) = .06143; F = <.121073, .083573, .061073>; sent <.160536, .070893, .026107>
//   l = .092412; F = <.189711, .122479, .088889>; seen <.194856, .080620, .028889>
#version 3.7;
global_settings { assumed_gamma 1
    radiosity { count 400 error_bound .2 pretrace_end .02
        recursion_limit 2 brightness 1.5 gray_threshold .5 }
    #ifdef (Glim) light_mesh { indirect { samples 4000 } } #end }
camera { location 0 look_at z }
sphere { 0, 5 hollow pigment { rgb <1, .5, .2> }
    finish { ambient .3 diffuse .5 emission .1 } }
