// A closed room, a red and a green wall, two blocks: what light does when it
// bounces. The ceiling sees no lamp from close by, yet it is not black.
//   glim room.pov +W400 +H300 --lighting path
//   Declare=Lamp=0   what shines: 0 a point, 1 an area light, 2 a glowing panel
//   Declare=Albedo=0.5     how much of the light the brightest walls give back
//   Declare=Radiosity=1    POV-Ray's radiosity, glim's indirect light mesh
//   Declare=Points=160     writes room.points (points.inc)
#version 3.7;
#ifndef (Lamp) #declare Lamp = 0; #end
#ifndef (Albedo) #declare Albedo = 0.5; #end
#ifndef (Radiosity) #declare Radiosity = 0; #end
global_settings {
  assumed_gamma 1
  #if (Radiosity)
    radiosity { count 400 error_bound 0.5 recursion_limit 4 }
  #end
}
#default { finish { ambient 0 diffuse Albedo } }

camera {
  location <0, 1.5, -2.9>
  look_at <0, 1.35, 0>
  right x * image_width / image_height
  angle 75
}

// The light of all three fades with distance: 2 / (1 + d^2 / 0.25) of Light.
#declare Light = <6.0, 5.6, 5.0>;
#switch (Lamp)
  #case (0)
    light_source { 2.4*y, Light fade_distance 0.5 fade_power 2 }
  #break
  #case (1)
    light_source {
      2.8*y, Light
      area_light x, z, 9, 9 adaptive 1
      fade_distance 0.5 fade_power 2
    }
  #break
  #else
    // Seen from below it is as bright as the point from afar.
    box {
      <-0.5, 2.9, -0.5>, <0.5, 2.92, 0.5>
      pigment { rgb 1 }
      finish { diffuse 0 emission 2 * 0.25 * pi * Light }
    }
#end

#macro Walls()
  box { <-2.2, -0.2, -3.2>, <2.2, 0, 2.2> pigment { rgb 1 } }
  box { <-2.2, 3, -3.2>, <2.2, 3.2, 2.2> pigment { rgb 1 } }
  box { <-2.2, 0, 2>, <2.2, 3, 2.2> pigment { rgb 1 } }
  box { <-2.2, 0, -3.2>, <2.2, 3, -3> pigment { rgb 1 } }
  box { <-2.2, 0, -3>, <-2, 3, 2> pigment { rgb <1, 0.16, 0.10> } }
  box { <2, 0, -3>, <2.2, 3, 2> pigment { rgb <0.20, 0.80, 0.16> } }
  box {
    <-0.6, 0, -0.6>, <0.6, 1.7, 0.6>
    rotate 20*y translate <-0.8, 0, 0.9>
    pigment { rgb 1 }
  }
  box {
    <-0.5, 0, -0.5>, <0.5, 0.9, 0.5>
    rotate -25*y translate <0.8, 0, -0.5>
    pigment { rgb <0.9, 0.8, 0.5> }
  }
#end
Walls()

#ifdef (Points)
  #include "points.inc"
  #declare Void = array[1][2] { { <-1.9, 1.8, -2.9>, <1.9, 2.9, 1.9> } }
  Write_Points("room.points", union { Walls() }, Void, Points)
#end
