// A glass ball, ior 1.5, as a lens.
// claims: rays path mesh soft
//
// A ray at the height b from the centre of a unit ball meets it at sin i = b,
// goes on at sin t = b/1.5, and leaves turned by 2 (i - t) to the axis, again
// at the distance b from the centre. At z = 3 it is (b - 3 sin d)/cos d from
// the axis, d = 2 (i - t). The wall glows red from 0 at x = -4 to 1 at x = 4.
//   b = .5: i = 30, t = 19.4712, d = 21.0576 degrees: -.619272
//   b = .8: i = 53.1301, t = 32.2310, d = 41.7983: -1.609040
//   b = .5 at (.3, .4): -.619272 * .6 = -.371563 in x
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
box { <-9, -9, 3>, <9, 9, 4>
    pigment { gradient x color_map { [0 rgb 0] [1 rgb x] }
        scale 8 translate -4*x }
    finish { ambient 0 diffuse 0 emission 1 } }
sphere { 0, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 }
    interior { ior 1.5 } }
