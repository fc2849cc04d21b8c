// Algebraic surfaces in a misty garden: quadric, cubic, quartic and poly.
// The equation of each stands above it; `clipped_by` or an intersection keeps
// the part worth seeing.
//   glim surfaces.pov +W900 +H500 +A
#version 3.7;
global_settings { assumed_gamma 1 }

camera {
  location <0, 2.5, -12.5>
  look_at <0, 1.5, 0>
  right x * image_width / image_height
  angle 40
}
light_source { <-7, 10, -9> rgb <1.25, 1.12, 0.92> }
light_source { <9, 5, -4> rgb <0.18, 0.25, 0.40> shadowless }
background { rgb <0.55, 0.62, 0.70> }
fog { distance 130 color rgb <0.55, 0.62, 0.70> }

plane {
  y, 0
  pigment {
    granite
    color_map { [0.2 rgb <0.10, 0.16, 0.05>] [0.8 rgb <0.22, 0.30, 0.10>] }
    scale 3
  }
  normal { bumps 0.5 scale 0.15 }
  finish { ambient 0.1 diffuse 0.8 }
}

#declare Clay = finish { ambient 0.12 diffuse 0.75 phong 0.5 phong_size 40 }
#declare Stand = union {
  cylinder { 0, 0.12*y, 0.85 }
  cylinder { 0.12*y, 0.5*y, 0.6 }
  cylinder { 0.5*y, 0.6*y, 0.8 }
  pigment {
    marble
    color_map { [0 rgb 0.75] [0.8 rgb 0.62] [1 rgb <0.35, 0.36, 0.38>] }
    turbulence 0.7 scale 0.6
  }
  finish { ambient 0.12 diffuse 0.75 }
}
#macro Show(Figure, Where)
  object { Figure translate Where + 1.65*y }
  object { Stand translate Where }
#end

// Hyperboloid of one sheet: x^2 - 0.35 y^2 + z^2 = 0.13
#declare Hyperboloid = intersection {
  quadric { <1, -0.35, 1>, <0, 0, 0>, <0, 0, 0>, -0.13 }
  box { -1.05, 1.05 }
  pigment { rgb <0.75, 0.42, 0.08> }
  finish { Clay }
}

// Cayley's nodal cubic, in the unit cube:
//   4 (x^2 + y^2 + z^2) + 16 xyz = 1
#declare Cayley = cubic {
  < 0, 0, 0, 4, 0, 16, 0, 0, 0, 0,
    0, 0, 4, 0, 0, 0, 0, 4, 0, -1>
  clipped_by { sphere { 0, 0.9 } }
  scale 1.4
  rotate <10, 20, 0>
  pigment { rgb <0.10, 0.34, 0.55> }
  finish { Clay }
}

// Goursat's quartic, a cube with six windows:
//   x^4 + y^4 + z^4 - (x^2 + y^2 + z^2) + 0.4 = 0
#declare Goursat = quartic {
  < 1, 0, 0, 0, 0, 0, 0, 0, 0, -1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    1, 0, 0, 0, 0, -1, 0, 0, 0, 0,
    1, 0, -1, 0, 0.4>
  scale 0.85
  rotate <25, 35, 0>
  pigment { rgb <0.60, 0.10, 0.12> }
  finish { Clay }
}

// Kummer's surface with sixteen nodes, as a poly of degree 4:
//   x^4 + y^4 + z^4 - x^2 - y^2 - z^2 - x^2 y^2 - x^2 z^2 - y^2 z^2 + 1 = 0
#declare Kummer = intersection {
  poly {
    4,
    < 1, 0, 0, 0, -1, 0, 0, -1, 0, -1,
      0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
      1, 0, 0, -1, 0, -1, 0, 0, 0, 0,
      1, 0, -1, 0, 1>
    sturm
  }
  sphere { 0, 2.4 }
  scale 0.46
  rotate <-12, 28, 0>
  pigment { rgb <0.42, 0.22, 0.55> }
  finish { Clay }
}

Show(Hyperboloid, <-3.45, 0, 0.3>)
Show(Cayley, <-1.15, 0, -0.5>)
Show(Goursat, <1.15, 0, -0.5>)
Show(Kummer, <3.45, 0, 0.3>)

// A hedge of stretched spheres runs into the fog.
#declare Seed = seed(5);
#for (I, -14, 14)
  #for (Side, 0, 2)
    sphere {
      0, 1
      scale <1.0 + 0.4 * rand(Seed), 1.3 + rand(Seed), 0.8>
      translate <I * 1.6 + rand(Seed), 0.7, 7 + 6 * Side + rand(Seed)>
      pigment { rgb <0.05, 0.10 + 0.06 * rand(Seed), 0.04> }
      normal { bumps 1 scale 0.12 }
      finish { ambient 0.1 diffuse 0.8 }
    }
  #end
#end
