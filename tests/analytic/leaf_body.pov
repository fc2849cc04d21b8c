// Two endless leaves, as the skins of a body, over a grey plate: what comes
// through the upper one is what is between them. All that is sent from the upper
// one's own side leaves the scene.
// claims: path bounced
// options path: --samples 1024
//
// The lamp L = <.2, .4, .6> shines down on the upper leaf. Leaves send on f = .3
// of what they get, and b = .6 of what their other sides get, times their colour
// p = <.8, .6, .4>; the plate a = .5. Down from the lower leaf comes
// p (b D + f k D) where D comes down from the upper one and the plate sends up k D,
// k = a p b/(1 - f p a). Up from the lower one comes U = p (f + b k) D,
// and D = p (b L + f U): D = p b L/(1 - f p p (f + b k)). The camera sees
// p (f L + b U).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, 3> look_at 0 right 3.2*x up 2.4*y }
light_source { 9*z, rgb <.2, .4, .6> parallel point_at 0 }
#default { finish { ambient 0 diffuse .3, .6 } }
plane { z, 0 pigment { rgb .5 } finish { ambient 0 diffuse 1, 0 } }
plane { z, 1.7 hollow pigment { rgb <.8, .6, .4> } }
plane { z, 2 hollow pigment { rgb <.8, .6, .4> } }
