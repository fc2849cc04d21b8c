// A closed hall with two rows of square pillars under beams, and one lamp near
// its end: light finds its way round every pillar, behind and before.
//   glim pillars.pov +W480 +H300 --lighting path
//   Declare=Albedo=0.5     how much of the light the walls give back
//   Declare=Radiosity=1    POV-Ray's radiosity, glim's indirect light mesh
//   Declare=Points=160     writes pillars.points (points.inc)
#version 3.7;
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
  location <13.3, 2.0, 2.2>
  look_at <4, 2.0, 3.3>
  right x * image_width / image_height
  angle 85
}
light_source { <2.6, 3.6, 2.9>, <120, 112, 96> fade_distance 0.5 fade_power 2 }

#macro Walls()
  box { <-0.2, -0.2, -0.2>, <13.8, 0, 5.8> pigment { rgb <1, 0.7, 0.5> } }
  box { <-0.2, 4.6, -0.2>, <13.8, 4.8, 5.8> pigment { rgb 1 } }
  box { <-0.2, 0, -0.2>, <0, 4.6, 5.8> pigment { rgb 1 } }
  box { <13.6, 0, -0.2>, <13.8, 4.6, 5.8> pigment { rgb 1 } }
  box { <0, 0, -0.2>, <13.6, 4.6, 0> pigment { rgb <0.6, 0.8, 1> } }
  box { <0, 0, 5.6>, <13.6, 4.6, 5.8> pigment { rgb <1, 0.8, 0.6> } }
  #for (Side, 0, 1)
    #for (I, 0, 6)
      box {
        <1.2, 0, 1.4>, <1.8, 2.6, 1.8>
        translate <1.8 * I, 0, 2.4 * Side>
        pigment { rgb 1 }
      }
    #end
    box {
      <0, 2.6, 1.4>, <13.6, 4.6, 1.8>
      translate 2.4 * Side * z
      pigment { rgb 1 }
    }
  #end
#end
Walls()

#ifdef (Points)
  #include "points.inc"
  #declare Void = array[3][2] {
    { <0.1, 0.1, 0.1>, <13.5, 4.5, 1.3> }
    { <0.1, 0.1, 1.9>, <13.5, 4.5, 3.7> }
    { <0.1, 0.1, 4.3>, <13.5, 4.5, 5.5> }
  }
  Write_Points("pillars.points", union { Walls() }, Void, Points)
#end
