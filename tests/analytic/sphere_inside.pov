// The light at the centre of a unit sphere, seen from there.
// claims: rays path mesh soft bounced many
// options path: --samples 8192 +SC33 +EC34 +SR25 +ER26
//
// Every wall point is lit head on, at distance 1, without fading: pigment *
// diffuse * cos 0 = <1, .6, .2> * .5. A wrong pi or cosine cannot survive.
//
// A method that follows light on (path) finds an integrating sphere: each
// bounce lights every point alike with albedo a times the light before, so the
// colour is a/(1 - a), a = <.5, .3, .1>.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 right 4/3*x angle 100 }
light_source { 0, rgb 1 }
sphere { 0, 1 pigment { rgb <1, .6, .2> } finish { ambient 0 diffuse .5 } }
