// One wide lamp over a table of things: soft shadows, sharp where a thing
// stands and wider the further they fall. Direct light only.
//   glim arealight.pov +W480 +H360
//   Declare=Grid=17        samples along each side of the area light
//   Declare=Adaptive=1     of area_light; below 0 without the word
//   Declare=Size=2.4       the light's side
//   Declare=Albedo=0.7     what surfaces give back; the less, the brighter the
//                          light: the picture stays, what bounces goes
//   Declare=Bare=1         leaves out all things: where there is no shadow
//   Declare=Points=1000     writes arealight.points (points.inc)
#version 3.7;
#ifndef (Grid) #declare Grid = 17; #end
#ifndef (Adaptive) #declare Adaptive = 1; #end
#ifndef (Size) #declare Size = 2.4; #end
#ifndef (Albedo) #declare Albedo = 0.7; #end
#ifndef (Bare) #declare Bare = 0; #end
global_settings { assumed_gamma 1 }
#default { finish { ambient 0 diffuse Albedo } }

camera {
  location <0, 3.4, -5.8>
  look_at <0, 0.75, 0>
  right x * image_width / image_height
  angle 58
}
light_source {
  <-1.5, 7, -1.5>, rgb 0.84 / Albedo
  #if (Grid > 1)
    area_light Size*x, Size*z, Grid, Grid
    #if (Adaptive >= 0) adaptive Adaptive #end
  #end
}

// Three walls of a room and its floor.
#macro Walls()
  box { <-5, -0.2, -7>, <5, 0, 4> pigment { rgb <0.9, 0.85, 0.75> } }
  box { <-5, 0, 4>, <5, 4, 4.2> pigment { rgb <0.75, 0.85, 0.95> } }
  box { <-5.2, 0, -7>, <-5, 4, 4.2> pigment { rgb <0.95, 0.7, 0.6> } }
  box { <5, 0, -7>, <5.2, 4, 4.2> pigment { rgb <0.7, 0.9, 0.7> } }
#end

// A table, and what stands on it and round it.
#macro Things()
  box { <-1.6, 1.0, -0.8>, <1.6, 1.1, 0.8> pigment { rgb <0.8, 0.6, 0.4> } }
  #for (X, -1, 1, 2)
    #for (Z, -1, 1, 2)
      cylinder {
        <1.5 * X, 0, 0.7 * Z>, <1.5 * X, 1.0, 0.7 * Z>, 0.06
        pigment { rgb <0.8, 0.6, 0.4> }
      }
    #end
  #end
  sphere { <-0.9, 1.45, 0>, 0.35 pigment { rgb <1, 0.4, 0.3> } }
  cone { <0, 1.1, 0.1>, 0.35, <0, 2.0, 0.1>, 0 pigment { rgb <0.4, 0.8, 0.5> } }
  torus {
    0.3, 0.1 rotate 70*x translate <0.95, 1.5, 0>
    pigment { rgb <0.4, 0.5, 1> }
  }
  box {
    <-0.5, 0, -0.5>, <0.5, 1.8, 0.5>
    rotate 25*y translate <3.2, 0, 1.6>
    pigment { rgb 0.9 }
  }
  #for (I, 0, 8)
    cylinder {
      <-4.4 + 0.28 * I, 0, 2.6>, <-4.4 + 0.28 * I, 2.2, 2.6>, 0.05
      pigment { rgb <0.95, 0.95, 0.8> }
    }
  #end
  sphere { <2.2, 0.4, -2>, 0.4 pigment { rgb <0.95, 0.8, 0.3> } }
#end
Walls()
#if (!Bare)
  Things()
#end

#ifdef (Points)
  #include "points.inc"
  // On the floor and the table: elsewhere the middle of the light may lie
  // behind the surface, and then POV-Ray's light is none.
  #declare Void = array[1][2] { { <-3, 1.2, -1.5>, <4, 2.5, 3> } }
  #declare Level = union {
    box { <-5, -0.2, -7>, <5, 0, 4> }
    box { <-1.6, 1.0999, -0.8>, <1.6, 1.1, 0.8> }
  }
  Write_Points("arealight.points", object { Level }, Void, Points)
#end
