// Glass: refraction, Fresnel reflection and colour that deepens with distance.
//   glim glass.pov +W800 +H500 +A
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 16 }

camera {
  location <0.1, 2.3, -11>
  look_at <0.1, 1.15, 0>
  right x * image_width / image_height
  angle 38
}

// A low sun behind the glasses, and light from the window side.
light_source { <6, 9, 8> rgb <1.1, 0.9, 0.65> }
light_source { <-9, 7, -6> rgb <0.42, 0.48, 0.58> }

sky_sphere {
  pigment {
    gradient y
    color_map {
      [0.00 rgb <1.00, 0.72, 0.42>]
      [0.12 rgb <0.95, 0.62, 0.50>]
      [0.45 rgb <0.38, 0.46, 0.70>]
      [0.80 rgb <0.20, 0.24, 0.45>]
      [1.00 rgb <0.62, 0.36, 0.30>]
    }
  }
}

// A table top of dark and light squares; beyond its edge is only the sky. It
// lies a hair below the glasses: of two surfaces in one place either may win.
box {
  <-7, -0.3, -5>, <7, -0.002, 4>
  pigment {
    checker rgb <0.03, 0.045, 0.07> rgb <0.62, 0.52, 0.42>
    scale 0.75
    rotate 45*y
  }
  finish { ambient 0.12 diffuse 0.7 reflection { 0.02, 0.4 } phong 0.2 }
}

#declare Clear = texture {
  pigment { rgbf <0.97, 0.985, 0.98, 0.97> }
  finish {
    ambient 0 diffuse 0
    reflection { 0, 1 fresnel } conserve_energy
    specular 0.8 roughness 0.002
  }
}
// Light loses half of its colour's complement in fade_distance units.
#macro Tinted(Colour, Distance)
  interior { ior 1.5 fade_distance Distance fade_power 1001 fade_color Colour }
#end

// A thick ball, a prism lying on its side, a ring, and a drinking glass.
sphere {
  <-2.35, 1.0, 0.4>, 1.0
  texture { Clear }
  Tinted(rgb <0.25, 0.85, 0.75>, 2.2)
}

intersection {
  plane { -y, 0 }
  plane { y, 0.62 rotate 60*z }
  plane { y, 0.62 rotate -60*z }
  plane { z, 0.95 }
  plane { -z, 0.95 }
  texture { Clear }
  Tinted(rgb <0.95, 0.80, 0.45>, 2.5)
  rotate 42*y
  translate <2.75, 0, -0.4>
}

torus {
  0.62, 0.22
  texture { Clear }
  Tinted(rgb <0.95, 0.25, 0.20>, 0.6)
  rotate <0, 0, 0>
  translate <-0.55, 0.22, -2.0>
}

// The drinking glass: an outer cone less an inner one, and what is poured in.
// The drink is a hair larger than the inner wall, so that no air lies between.
#declare Wall = 0.07;
difference {
  cone { 0, 0.62, 2.3*y, 0.82 }
  cone { 0.22*y, 0.62 - Wall, 2.31*y, 0.82 - Wall }
  texture { Clear }
  interior { ior 1.5 }
  translate <0.55, 0, 0.3>
}
cone {
  0.221*y, 0.551, 1.45*y, 0.651
  texture { Clear }
  interior {
    ior 1.33
    fade_distance 0.8 fade_power 1001 fade_color rgb <0.97, 0.50, 0.08>
  }
  translate <0.55, 0, 0.3>
}
// A straw, bent by the water.
cylinder {
  <-0.42, 0.3, 0.05>, <0.78, 3.05, -0.1>, 0.06
  pigment { gradient y color_map { [0.5 rgb <0.8, 0.04, 0.05>] [0.5 rgb 0.9] }
            scale 0.3 rotate 20*z }
  finish { ambient 0.15 diffuse 0.7 phong 0.4 }
  translate <0.55, 0, 0.3>
}

// Marbles.
#declare Seed = seed(11);
#for (I, 0, 6)
  sphere {
    <-0.9 + 0.52 * I, 0.2, -2.9 + 0.55 * rand(Seed)>, 0.2
    texture { Clear }
    Tinted(rgb <rand(Seed), rand(Seed), rand(Seed)>, 0.25)
  }
#end
