// Bench: constructive solid geometry and quadrics, in loops. 10 by 10 pieces:
// dice with spots cut out, lenses, drilled rods, and bells of a quadric.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Side) #declare Side = 10; #end

camera {
  location <-7.5, 8.5, -10.5>
  look_at <0.2, -0.4, -0.4>
  right x * image_width / image_height
  angle 42
}
light_source { <-12, 16, -6> rgb <1.1, 1.05, 0.95> }
light_source { <9, 12, -14> rgb <0.3, 0.35, 0.45> }
background { rgb <0.45, 0.55, 0.70> }
plane { y, 0 pigment { checker rgb 0.75 rgb 0.55 } }

#declare Die = difference {
  intersection {
    box { -0.38, 0.38 }
    sphere { 0, 0.55 }
  }
  #for (Face, 0, 3)
    union {
      sphere { <0, 0, -0.40>, 0.08 }
      #for (I, 0, Face)
        sphere { <0.22, 0, -0.40>, 0.07 rotate 360 / (Face + 1) * I * z }
      #end
      rotate 90 * Face * y
    }
  #end
  sphere { 0.40*y, 0.16 }
  translate 0.38*y
}
#declare Lens = intersection {
  sphere { -0.45*z, 0.62 }
  sphere { 0.45*z, 0.62 }
  cylinder { -z, z, 0.36 }
  translate 0.36*y
}
#declare Rod = difference {
  cylinder { 0, 0.8*y, 0.32 }
  cylinder { 0.1*y, y, 0.22 }
  #for (I, 0, 3)
    cylinder { 0, x, 0.08 translate (0.18 + 0.16 * I) * y rotate 35 * I * y }
    cylinder { 0, -x, 0.08 translate (0.18 + 0.16 * I) * y rotate 35 * I * y }
  #end
}
#declare Bell = difference {
  intersection {
    quadric { <1, 0, 1>, <0, 0, 0>, <0, 0.28, 0>, -0.22 }
    plane { y, 0.75 }
    plane { -y, 0 }
  }
  quadric { <1, 0, 1>, <0, 0, 0>, <0, 0.28, 0>, -0.17 }
  cone { 0.3*y, 0.05, 0.9*y, 0.2 }
}

#declare Seed = seed(4);
#for (X, 1, Side)
  #for (Z, 1, Side)
    object {
      #switch (mod(X + 2 * Z, 4))
        #case (0) Die #break
        #case (1) Lens #break
        #case (2) Rod #break
        #else Bell
      #end
      rotate 360 * rand(Seed) * y
      translate <X - (Side + 1) / 2, 0, Z - (Side + 1) / 2>
      pigment { rgb <0.25 + 0.6 * rand(Seed), 0.2 + 0.5 * rand(Seed),
                     0.15 + 0.4 * rand(Seed)> }
      finish { phong 0.5 phong_size 50 }
    }
  #end
#end
