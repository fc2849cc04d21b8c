// A gallery of the patterns, each on its own ball, with its name in a comment.
// The balls on the front row show what a pattern does as a normal.
//   glim patterns.pov +W900 +H600 +A
#version 3.7;
global_settings { assumed_gamma 1 }

camera {
  location <0, 5.6, -17>
  look_at <0, 1.95, 0.1>
  right x * image_width / image_height
  angle 42
}
light_source { <-8, 14, -12> rgb 1.15 }
light_source { <12, 8, -8> rgb <0.22, 0.25, 0.32> shadowless }
background { rgb <0.02, 0.025, 0.035> }

#default { finish { ambient 0.1 diffuse 0.85 phong 0.35 phong_size 50 } }

// Colours that the maps share.
#declare Ink = rgb <0.02, 0.05, 0.12>;
#declare Sea = rgb <0.03, 0.30, 0.42>;
#declare Sand = rgb <0.85, 0.68, 0.40>;
#declare Rust = rgb <0.55, 0.14, 0.04>;
#declare Cream = rgb <0.90, 0.85, 0.74>;
#declare Warm = color_map { [0 Ink] [0.35 Rust] [0.7 Sand] [1 Cream] }
#declare Cool = color_map { [0 Ink] [0.5 Sea] [1 Cream] }

#declare Count = 21;
#declare Pigments = array[Count] {
  pigment { checker Ink Cream scale 0.4 }
  pigment { hexagon Rust Sand Sea scale 0.25 rotate 90*x }
  pigment { brick Cream, Rust brick_size <0.5, 0.2, 0.3> mortar 0.03 }
  pigment { gradient y color_map { Cool } scale 0.5 triangle_wave }
  pigment { radial color_map { Warm } frequency 8 }
  pigment { onion color_map { Cool } scale 0.2 translate <0.6, 0.3, -0.5> }
  pigment { leopard color_map { Warm } scale 0.07 }

  pigment { wood color_map { Warm } turbulence 0.08 scale 0.25 rotate 30*y }
  pigment { marble color_map { Cool } turbulence 0.9 scale 0.45 }
  pigment { agate color_map { Warm } scale 0.5 }
  pigment { granite color_map { Cool } scale 0.8 }
  pigment { bozo color_map { Warm } scale 0.25 }
  pigment { spotted color_map { Cool } scale 0.2 }
  pigment { crackle color_map { [0 Ink] [0.12 Rust] [1 Sand] } scale 0.35 }

  // The waves of the ramp: the same gradient, folded in different ways.
  pigment { gradient x color_map { Warm } scale 0.5 sine_wave }
  pigment { gradient x color_map { Warm } scale 0.5 scallop_wave }
  // A map of pigments: checkers blend into bricks through bozo.
  pigment {
    bozo
    pigment_map {
      [0.45 checker Sea Cream scale 0.15]
      [0.55 brick Cream, Rust brick_size <0.4, 0.15, 0.2> mortar 0.02]
    }
    scale 0.8
  }
  pigment { rgb <0.30, 0.36, 0.42> }
  pigment { rgb <0.42, 0.34, 0.25> }
  pigment { rgb <0.25, 0.38, 0.32> }
  pigment { rgb <0.42, 0.26, 0.26> }
}
// The normals of the last four.
#declare Normals = array[4] {
  normal { bumps 0.7 scale 0.12 }
  normal { dents 2 scale 0.15 }
  normal { ripples 0.8 scale 0.2 }
  normal { wrinkles 1 scale 0.35 }
}

#for (I, 0, Count - 1)
  #local Column = mod(I, 7);
  #local Row = int(I / 7);
  union {
    sphere {
      0.92*y, 0.8
      pigment { Pigments[I] translate 0.92*y }
      #if (I >= Count - 4) normal { Normals[I - Count + 4] } #end
    }
    torus {
      0.42, 0.09 translate 0.1*y
      pigment { rgb <0.45, 0.38, 0.25> }
      finish { reflection 0.15 metallic specular 0.5 roughness 0.02 }
    }
    translate <(Column - 3) * 1.85, 1.3 * (2 - Row), 4.0 - 2.2 * Row>
  }
#end

// The steps they stand on.
#for (Row, 0, 2)
  box {
    <-7.2, -1, 2.9 - 2.2 * Row>, <7.2, 1.3 * (2 - Row), 8>
    pigment { rgb <0.16, 0.15, 0.15> }
    finish { phong 0 reflection 0.03 }
  }
#end
plane { y, 0 pigment { rgb <0.10, 0.10, 0.11> } }
