// Light through panes: filter colours it, transmit weakens it, a solid pane
// counts twice, no_shadow not at all.
// claims: rays path mesh soft
//
// A parallel light from <3, 0, -4> meets the wall z = 0 with cosine .8; panes
// at z = -2 (seen edge on: they are turned along the view) would hide nothing,
// so they stand aside, up the light's way: a pane around <x + 1.5, y, -2>
// shades the point (x, y). The view is along z, so a pane over x in 1.1...1.9
// hides those pixels and shades -.4...4. Bands of y:
//   y = 1.6: disc, rgbf <.5, 1, .25, .8>: .8 * <.4, .8, .2> = <.32, .64, .16>
//   y = .5: disc, rgbt <.5, 1, .25, .7>: .8 * .7 = .56
//   y = -.6: box, rgbf <.5, 1, .25, .8>: .8 * <.16, .64, .04>
//   y = -1.7: an opaque disc, no_shadow: .8
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
light_source { <3, 0, -4>, rgb 1 parallel point_at 0 }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
#default { finish { ambient 0 diffuse 0 } }
disc { <1.5, 1.6, -2>, z, .4 pigment { rgbf <.5, 1, .25, .8> } }
disc { <1.5, .5, -2>, z, .4 pigment { rgbt <.5, 1, .25, .7> } }
box { <1.1, -1, -2.1>, <1.9, -.2, -1.9> pigment { rgbf <.5, 1, .25, .8> } }
disc { <1.5, -1.7, -2>, z, .4 pigment { rgb 0 } no_shadow }
