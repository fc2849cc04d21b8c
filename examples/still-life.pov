// A still life on a checker floor: mirrors, phong highlights and a soft sky.
//   glim still-life.pov +W800 +H500 +A
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }

camera {
  location <0.7, 2.5, -10>
  look_at <0.3, 1.6, 0>
  right x * image_width / image_height
  angle 40
}

// The lamp is warm and stands on the left; a weak cool one fills the shadows.
light_source { <-7, 9, -6> rgb <1.15, 1.0, 0.8> }
light_source { <8, 5, -7> rgb <0.10, 0.16, 0.28> shadowless }

sky_sphere {
  pigment {
    gradient y
    color_map {
      [0.0 rgb <0.72, 0.50, 0.34>]
      [0.25 rgb <0.30, 0.36, 0.50>]
      [1.0 rgb <0.04, 0.08, 0.22>]
    }
  }
}

#default { finish { ambient 0.12 diffuse 0.75 } }

plane {
  y, 0
  pigment {
    checker rgb <0.85, 0.80, 0.68> rgb <0.10, 0.055, 0.035>
    rotate 32*y
  }
  finish { reflection { 0.04, 0.35 } phong 0.3 phong_size 120 }
}

#declare Glaze = finish { phong 0.9 phong_size 90 reflection { 0.03, 0.3 } }
#declare Skin = finish { phong 0.45 phong_size 25 }

// A vase of five parts. The neck is a cone, the lip and the foot are tori.
#declare Vase = merge {
  sphere { 0, 1 scale <0.95, 1.05, 0.95> translate 1.05*y }
  cone { 1.75*y, 0.60, 2.6*y, 0.26 }
  torus { 0.30, 0.09 translate 2.62*y }
  torus { 0.52, 0.10 translate 0.10*y }
  cylinder { 0*y, 0.2*y, 0.52 }
}
difference {
  object { Vase }
  cone { 1.9*y, 0.40, 2.9*y, 0.20 }
  pigment {
    gradient y
    color_map {
      [0.00 rgb <0.01, 0.10, 0.14>]
      [0.55 rgb <0.02, 0.26, 0.30>]
      [0.56 rgb <0.70, 0.62, 0.42>]
      [0.60 rgb <0.70, 0.62, 0.42>]
      [0.61 rgb <0.02, 0.26, 0.30>]
      [1.00 rgb <0.01, 0.12, 0.18>]
    }
    scale 2.8
  }
  finish { Glaze }
  translate <-1.35, 0, 0.9>
}

// Three stems that bend, each a row of spheres and cylinders, with a poppy.
#macro Stem(Turn, Lean, Height)
  union {
    #local Steps = 10;
    #local At = <0, 1.6, 0>;
    #for (I, 1, Steps)
      #local Next = <Lean * pow(I / Steps, 2), 1.6 + Height * I / Steps, 0>;
      cylinder { At, Next, 0.028 }
      sphere { Next, 0.028 }
      #local At = Next;
    #end
    union {
      #for (I, 0, 5)
        sphere {
          0, 0.26
          scale <1, 0.28, 0.72>
          translate 0.2*x
          rotate <0, 60 * I, 18>
          rotate 60 * I * y
        }
      #end
      sphere { 0.06*y, 0.11 pigment { rgb <0.03, 0.02, 0.03> } }
      pigment { rgb <0.78, 0.05, 0.02> }
      finish { Skin }
      rotate <-35, 0, -25>
      translate At
    }
    pigment { rgb <0.10, 0.22, 0.05> }
    rotate Turn * y
    translate <-1.35, 0, 0.9>
  }
#end
Stem(20, 0.55, 2.0)
Stem(160, 0.75, 1.55)
Stem(255, 0.45, 1.75)

// An apple is a torus that runs through its own centre.
#macro Apple(Where, Turn, Tone)
  union {
    torus {
      0.26, 0.36
      scale <1, 1.06, 1>
      pigment {
        gradient y
        color_map {
          [0.0 rgb <0.62, 0.52, 0.10>]
          [0.4 Tone]
          [0.8 Tone * 0.8]
          [1.0 rgb <0.5, 0.42, 0.08>]
        }
        scale 0.8
        translate -0.4*y
      }
      finish { Skin }
    }
    cone {
      0, 0.02, 0.42*y, 0.035
      rotate 14*z
      pigment { rgb <0.12, 0.06, 0.02> }
    }
    rotate Turn
    translate Where + 0.38*y
  }
#end
Apple(<0.35, 0, -1.25>, <0, 0, 8>, rgb <0.60, 0.03, 0.02>)
Apple(<1.25, 0, -1.9>, <12, 70, -6>, rgb <0.45, 0.30, 0.03>)

// A lemon: a sphere pulled long, with a tip at either end.
merge {
  sphere { 0, 0.4 scale <1.35, 1, 1> }
  sphere { 0, 0.14 scale <1.6, 1, 1> translate 0.5*x }
  sphere { 0, 0.14 scale <1.3, 1, 1> translate -0.5*x }
  pigment { rgb <0.85, 0.60, 0.03> }
  normal { bumps 0.15 scale 0.05 }
  finish { Skin }
  rotate 152*y
  translate <-0.62, 0.4, -1.75>
}

// A mirror ball and a copper one.
sphere {
  <1.35, 1.05, 0.6>, 1.05
  pigment { rgb 0.03 }
  finish { ambient 0 diffuse 0.3 reflection 0.82 phong 1 phong_size 200 }
}
sphere {
  <2.75, 0.42, -1.0>, 0.42
  pigment { rgb <0.75, 0.36, 0.16> }
  finish {
    diffuse 0.35
    reflection { 0.55 metallic }
    specular 0.7 roughness 0.02 metallic
  }
}
