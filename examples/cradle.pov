// Newton's cradle, an animation: `clock` runs from 0 to 1 for one full swing.
// The last frame would equal the first, so +KC (cyclic) leaves it out.
//   glim cradle.pov +W640 +H400 +A +KFF24 +KC
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }

camera {
  location <2.9, 2.8, -9.9>
  look_at <-0.1, 1.66, 0>
  right x * image_width / image_height
  angle 38
}
light_source { <-6, 10, -8> rgb <1.15, 1.08, 0.98> }
light_source { <9, 7, -3> rgb <0.22, 0.26, 0.36> }
sky_sphere {
  pigment {
    gradient y
    color_map {
      [0.0 rgb <0.90, 0.66, 0.42>]
      [0.3 rgb <0.45, 0.42, 0.45>]
      [0.5 rgb <0.16, 0.20, 0.28>]
      [0.6 rgb <1.15, 1.12, 1.05>]
      [0.7 rgb <0.16, 0.20, 0.28>]
      [1.0 rgb <0.06, 0.08, 0.12>]
    }
  }
}

// A ball on either side swings out by turns; a cosine is near enough.
#declare Reach = 38;
#declare Phase = 2 * pi * clock;
#declare Left = -Reach * max(0, cos(Phase));
#declare Right = Reach * max(0, -cos(Phase));

#declare Balls = 5;
#declare Radius = 0.42;
#declare Rail = 3.3;
#declare Drop = Rail - 1.05;

#declare Chrome = texture {
  pigment { rgb <0.85, 0.84, 0.80> }
  finish {
    ambient 0.02 diffuse 0.12
    reflection { 0.85 metallic } specular 0.9 roughness 0.006
  }
}

#for (I, 0, Balls - 1)
  union {
    sphere { -Drop*y, Radius texture { Chrome } }
    cylinder {
      (Radius * 0.98 - Drop) * y, (Radius * 1.1 - Drop) * y, 0.05
      texture { Chrome }
    }
    union {
      cylinder { (Radius - Drop) * y, -0.9*z, 0.011 }
      cylinder { (Radius - Drop) * y, 0.9*z, 0.011 }
      pigment { rgb <0.75, 0.70, 0.55> }
    }
    #switch (I)
      #case (0) rotate Left * z #break
      #case (Balls - 1) rotate Right * z #break
    #end
    translate <(I - (Balls - 1) / 2) * 2 * Radius, Rail, 0>
  }
#end

// The frame: two bent rods on a wooden base.
#macro Rod(Z)
  cylinder { <-2.0, Rail, Z>, <2.0, Rail, Z>, 0.055 }
  #for (Side, -1, 1, 2)
    intersection {
      torus { 0.25, 0.055 rotate 90*x }
      box { <0, 0, -1>, <1, 1, 1> scale <Side, 1, 1> }
      translate <2.0 * Side, Rail - 0.25, Z>
    }
    cylinder { <2.25 * Side, Rail - 0.25, Z>, <2.25 * Side, 0.2, Z>, 0.055 }
  #end
#end
union { Rod(-0.9) Rod(0.9) texture { Chrome } }
intersection {
  box { <-2.6, 0, -1.25>, <2.6, 0.26, 1.25> }
  plane { y, 0 rotate 32*x translate <0, 0.22, -1.2> inverse }
  plane { y, 0.255 }
  pigment {
    wood
    color_map { [0 rgb <0.30, 0.13, 0.06>] [1 rgb <0.14, 0.05, 0.02>] }
    turbulence 0.05
    scale 0.14
    rotate <0, 88, 5>
  }
  finish { ambient 0.1 diffuse 0.65 phong 0.4 reflection { 0.03, 0.25 } }
}
plane {
  y, 0
  pigment {
    hexagon
    rgb <0.03, 0.10, 0.13> rgb <0.03, 0.13, 0.16> rgb <0.05, 0.15, 0.17>
  }
  finish { ambient 0.12 diffuse 0.6 reflection { 0.02, 0.3 } }
}
