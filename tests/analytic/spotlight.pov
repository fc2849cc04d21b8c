// A spotlight: the smooth step is taken between the cosines of falloff and
// radius, then the power of tightness.
// claims: rays path mesh soft
//
// The light is at <0, 0, -3> and points at the wall z = 0; at distance r from
// the centre c = 3/sqrt(r^2 + 9). Radius 10, falloff 30, tightness 4: with
// s = (c - cos 30)/(cos 10 - cos 30), clamped, the colour is
// s^2 (3 - 2s) * c^4 * c, the last c being Lambert's.
//   r = 0: 1
//   r = .5: c = .986394 (9.46 degrees, inside the radius): c^5 = .933796
//   r = 1: c = .948683, s = .695877, s^2(3 - 2s) = .778785: * c^5 = .598444
//   r = 1.5: c = .894427, s = .239108, .144177: * c^5 = .082532
//   r = 2: 33.7 degrees, 0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
light_source { <0, 0, -3>, rgb 1
    spotlight radius 10 falloff 30 tightness 4 point_at 0 }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
