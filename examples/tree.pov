// A tree grown by a macro that calls itself. Each branch bends, thins out and
// splits; the last twigs carry leaves. Another seed grows another tree:
//   glim tree.pov +W600 +H700 +A Declare=Kind=7
#version 3.7;
global_settings { assumed_gamma 1 }

#ifndef (Kind) #declare Kind = 3; #end
#ifndef (Depth) #declare Depth = 8; #end
#declare Seed = seed(Kind);

camera {
  location <0, 2.0, -18>
  look_at <0.6, 3.9, 0>
  right x * image_width / image_height
  angle 35
}
light_source { <-40, 46, -50> rgb <1.9, 1.6, 1.15> }
light_source { <30, 20, -40> rgb <0.12, 0.17, 0.26> shadowless }

sky_sphere {
  pigment {
    gradient y
    color_map {
      [0.0 rgb <0.92, 0.80, 0.62>]
      [0.3 rgb <0.45, 0.60, 0.78>]
      [0.8 rgb <0.10, 0.24, 0.52>]
    }
  }
  pigment {
    bozo
    turbulence 0.7
    color_map {
      [0.45 rgbt <1, 1, 1, 1>]
      [0.65 rgbt <1, 0.97, 0.92, 0.5>]
      [0.85 rgbt <0.90, 0.86, 0.84, 0.3>]
    }
    scale <0.2, 0.04, 0.2>
  }
}
// The fog lets two thirds of the sky through.
fog { distance 260 color rgbt <0.85, 0.78, 0.68, 0.66> }

// Leaves in two tones; one leaf is two triangles folded along its rib.
#declare Leaf = mesh {
  triangle { 0, <0, 0.16, 0.02>, <0.05, 0.08, -0.01> }
  triangle { 0, <0, 0.16, 0.02>, <-0.05, 0.08, -0.01> }
}
#macro Leaves(Where)
  #for (L, 1, 7)
    object {
      Leaf
      scale 1.15 + 0.7 * rand(Seed)
      rotate <160 * rand(Seed) - 30, 360 * rand(Seed), 0>
      translate Where + 0.26 * <rand(Seed) - 0.5, rand(Seed) - 0.5,
                                rand(Seed) - 0.5>
      #local Tone = rand(Seed);
      pigment { rgb <0.10 + 0.32 * Tone, 0.26 - 0.02 * Tone, 0.03> }
      finish { ambient 0.18 diffuse 0.8 }
    }
  #end
#end

// From, along Axis, Length long, Thick at its foot, Level splits to go.
#macro Branch(From, Axis, Length, Thick, Level)
  #local Tip = From + Length * Axis;
  cone { From, Thick, Tip, Thick * 0.72 }
  sphere { Tip, Thick * 0.72 }
  #if (Level > 0)
    #local Side = vnormalize(vcross(Axis, <0.37, 0.2, 0.91>));
    #local Turn = 360 * rand(Seed);
    #local Children = 2 + (rand(Seed) < 0.35);
    #for (C, 1, Children)
      #local Lean = 17 + 23 * rand(Seed);
      #local Way = vaxis_rotate(Side, Axis, Turn + C * 360 / Children);
      #local New = vnormalize(vaxis_rotate(Axis, Way, Lean) + 0.09*y);
      Branch(Tip, New, Length * (0.74 + 0.14 * rand(Seed)), Thick * 0.68,
             Level - 1)
    #end
  #end
  #if (Level < 3) Leaves(Tip) #end
#end

union {
  Branch(<0, 0, 0>, vnormalize(<0.04, 1, 0.02>), 1.55, 0.3, Depth)
  pigment {
    wood
    color_map { [0 rgb <0.10, 0.06, 0.04>] [1 rgb <0.24, 0.16, 0.10>] }
    turbulence 0.2 scale <0.06, 0.5, 0.06>
  }
  normal { bumps 0.6 scale <0.04, 0.2, 0.04> }
  finish { ambient 0.12 diffuse 0.75 }
}

// A meadow with a swell, and hills behind it.
sphere {
  0, 1
  scale <60, 3, 60>
  translate -3.05*y
  pigment {
    bozo
    color_map { [0.3 rgb <0.10, 0.18, 0.03>] [0.7 rgb <0.26, 0.30, 0.06>] }
    scale <1.2, 1, 0.4>
  }
  normal { bumps 0.8 scale 0.06 }
  finish { ambient 0.12 diffuse 0.8 }
}
#for (H, 0, 8)
  sphere {
    0, 1
    scale <42 + 20 * rand(Seed), 7 + 9 * rand(Seed), 20>
    translate <-120 + 30 * H, -3, 90 + 40 * rand(Seed)>
    pigment { rgb <0.10, 0.16, 0.09> }
    finish { ambient 0.12 diffuse 0.7 }
  }
#end
