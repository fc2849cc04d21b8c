// Where media are looked at more closely: what is compared with aa_threshold
// is the light of a whole interval, not that of a unit of length. Deep boxes
// that glow little per unit are refined as flat ones that glow much; intervals
// of half the length need twice the light.
// compare: exact
// options: +W180 +H60
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10 * z look_at 0 right 6 * x up 2 * y }
#macro Deep(X, Y, Depth, Glow, Intervals)
  box { 0, 1 hollow pigment { rgbt 1 }
    interior { media { emission Glow / Depth samples 10 method 3
      intervals Intervals aa_threshold 0.8 aa_level 5
      density { function { select(z / Depth - x, 0, 1) }
        color_map { [0 rgb 0] [1 rgb 1] } } } }
    scale <1, 1, Depth> translate <X, Y, 0> }
#end
Deep(-3, 0, 0.25, 0.3, 1)
Deep(-2, 0, 0.25, 0.2, 1)
Deep(-1, 0, 4, 0.3, 1)
Deep(0, 0, 4, 0.2, 1)
Deep(1, 0, 4, 0.3, 2)
Deep(2, 0, 4, 0.6, 2)
Deep(-3, -1, 0.25, 0.6, 4)
Deep(-2, -1, 16, 0.6, 1)
Deep(-1, -1, 1, 0.6, 1)
Deep(0, -1, 1, 0.25, 1)
