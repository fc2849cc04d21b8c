// A room with two area lights, the window and a lamp: soft shadows, a carpet
// that is an image_map, and a block that only glim reads.
//   glim room.pov +W800 +H500 +A
#version 3.7;
global_settings { assumed_gamma 1 }

// POV-Ray does not know the name Glim and skips what stands here: the place
// for glim's own settings in a scene that both programs draw.
#ifdef (Glim)
  #debug concat("room.pov: drawn by glim ", str(Glim, 0, 1), "\n")
#end

// Samples along each side of an area light.
#ifndef (Samples) #declare Samples = 9; #end

camera {
  location <-1.0, 1.55, -4.3>
  look_at <0.1, 1.16, 0>
  right x * image_width / image_height
  angle 54
}

// Daylight through the window on the left.
light_source {
  <-3.9, 2.2, 0.2>, rgb <1.0, 1.08, 1.2>
  area_light <0, 1.5, 0>, <0, 0, 1.9>, Samples, Samples adaptive 2
  fade_distance 3.2 fade_power 2
}
// A paper lamp above the table.
#declare Lamp = <0.75, 2.35, 0.7>;
light_source {
  Lamp, rgb <0.62, 0.44, 0.24>
  area_light 0.45*x, 0.45*z, Samples, Samples adaptive 2
  fade_distance 2 fade_power 2
  looks_like {
    sphere {
      0, 0.33
      scale <1, 0.85, 1>
      pigment { rgb <1, 0.86, 0.62> }
      normal { gradient y 0.8 scallop_wave scale 0.07 }
      finish { ambient 0 emission 0.95 diffuse 0.2 }
    }
  }
}
cylinder { Lamp, <Lamp.x, 3, Lamp.z>, 0.012 pigment { rgb 0.05 } no_shadow }

#default { finish { ambient rgb <0.14, 0.14, 0.15> diffuse 0.75 } }

#declare Oak = texture {
  pigment {
    wood
    color_map {
      [0.0 rgb <0.50, 0.30, 0.14>]
      [0.7 rgb <0.36, 0.19, 0.08>]
      [1.0 rgb <0.24, 0.12, 0.05>]
    }
    turbulence 0.06
    scale 0.09
    rotate <4, 0, 88>
  }
  finish { phong 0.35 phong_size 60 reflection { 0.01, 0.12 } }
}

// Walls, ceiling, and a floor of boards.
difference {
  box { <-3.7, -0.2, -7>, <3.9, 3.2, 3.4> }
  box { <-3.4, 0, -6.8>, <3.6, 3.0, 3.1> }
  box { <-4.5, 0.95, -0.85>, <-3, 2.45, 1.25> }
  pigment { rgb <0.72, 0.68, 0.58> }
}
box {
  <-3.4, 0, -6.8>, <3.6, 0.01, 3.1>
  texture { Oak rotate 90*y }
}
union {
  box { <-3.4, 0, 3.06>, <3.6, 0.12, 3.1> }
  box { <3.56, 0, -6>, <3.6, 0.12, 3.1> }
  pigment { rgb 0.82 }
}
// The cross of the window, its sill, and the sky outside.
union {
  box { <-3.58, 0.95, 0.17>, <-3.52, 2.45, 0.23> }
  box { <-3.58, 1.72, -0.85>, <-3.52, 1.78, 1.25> }
  box { <-3.7, 0.88, -0.95>, <-3.2, 0.95, 1.35> }
  pigment { rgb 0.85 }
}
background { rgb <0.62, 0.78, 0.98> }

// The carpet: 48 by 32 pixels of wool, laid flat.
box {
  0, 1
  pigment { image_map { png "rug.png" once } }
  normal { bumps 0.4 scale 0.008 }
  scale <3.3, 2.2, 0.02>
  rotate 90*x
  translate <-1.25, 0.035, -1.15>
}

// Table and stools: rounded boxes are a merge of spheres and cylinders.
union {
  box { <-0.95, 0.70, -0.5>, <0.95, 0.75, 0.5> }
  #for (X, -1, 1, 2)
    #for (Z, -1, 1, 2)
      cone { <0.78 * X, 0.7, 0.36 * Z>, 0.045, <0.86 * X, 0, 0.42 * Z>, 0.028 }
    #end
  #end
  texture { Oak }
  rotate -12*y
  translate <0.75, 0.01, 0.7>
}
#macro Stool(Where, Turn)
  union {
    cylinder { 0.42*y, 0.46*y, 0.2 }
    torus { 0.2, 0.02 translate 0.44*y }
    #for (I, 0, 2)
      cone {
        <0.13, 0.43, 0>, 0.026, <0.22, 0, 0>, 0.018
        rotate (120 * I + Turn) * y
      }
    #end
    translate Where + 0.01*y
  }
#end
object { Stool(<-0.75, 0, 0.35>, 20) pigment { rgb <0.10, 0.22, 0.26> } }
object { Stool(<0.35, 0, -0.75>, 65) pigment { rgb <0.50, 0.16, 0.08> } }
object { Stool(<2.25, 0, 0.0>, 0) pigment { rgb <0.55, 0.42, 0.12> } }

// A teapot of a kind, and two cups.
union {
  sphere { 0.13*y, 0.14 }
  sphere { 0.28*y, 0.028 }
  torus { 0.075, 0.014 translate 0.245*y }
  difference {
    torus { 0.095, 0.016 rotate 90*x translate <-0.15, 0.14, 0> }
    sphere { 0.13*y, 0.13 }
  }
  cone { <0.1, 0.1, 0>, 0.04, <0.26, 0.23, 0>, 0.018 }
  pigment { rgb <0.06, 0.20, 0.17> }
  finish { phong 0.8 phong_size 80 reflection { 0.02, 0.25 } }
  rotate 35*y
  translate <0.55, 0.76, 0.75>
}
#declare Cup = difference {
  cone { 0, 0.035, 0.085*y, 0.055 }
  cone { 0.01*y, 0.03, 0.09*y, 0.051 }
  pigment { rgb 0.85 }
  finish { phong 0.6 phong_size 60 }
}
object { Cup translate <0.95, 0.76, 0.5> }
object { Cup translate <1.15, 0.76, 0.85> }

// A picture, and a shelf with books along the far wall.
union {
  difference {
    box { <-0.78, -0.55, -0.05>, <0.78, 0.55, 0> }
    box { <-0.68, -0.45, -0.1>, <0.68, 0.45, 0.1> }
    texture { Oak }
  }
  box {
    <-0.68, -0.45, -0.02>, <0.68, 0.45, -0.015>
    pigment {
      onion
      color_map {
        [0.0 rgb <0.04, 0.08, 0.20>]
        [0.3 rgb <0.10, 0.35, 0.48>]
        [0.5 rgb <0.85, 0.70, 0.42>]
        [0.8 rgb <0.70, 0.20, 0.08>]
        [1.0 rgb <0.04, 0.08, 0.20>]
      }
      scale 0.42
      translate <-0.25, -0.12, 0>
    }
  }
  translate <-1.55, 1.75, 3.1>
}
union {
  box { <0.6, 1.40, 2.82>, <3.1, 1.44, 3.1> texture { Oak rotate 90*y } }
  #declare Seed = seed(20);
  #declare At = 0.68;
  #while (At < 2.9)
    #local Thick = 0.035 + 0.05 * rand(Seed);
    #local Tall = 0.24 + 0.14 * rand(Seed);
    #if (rand(Seed) < 0.85)
      box {
        <0, 0, 0>, <Thick - 0.004, Tall, 0.2>
        #if (rand(Seed) < 0.12) rotate -9*z #end
        translate <At, 1.44, 2.86>
        pigment { rgb 0.05 + 0.5 * <rand(Seed), rand(Seed) * 0.7,
                                    rand(Seed) * 0.6> }
        finish { phong 0.2 }
      }
    #end
    #declare At = At + Thick;
  #end
}
