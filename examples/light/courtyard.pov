// A courtyard under a blue sky and a low sun: bright in the middle, dim under
// the arcade, and a room behind it that only the door lights.
//   glim courtyard.pov +W480 +H320 --lighting path
//   Declare=Albedo=0.5     how much of the light the walls give back
//   Declare=Radiosity=1    POV-Ray's radiosity, glim's indirect light mesh
//   Declare=Points=160     writes courtyard.points (points.inc)
#version 3.7;
#ifndef (Albedo) #declare Albedo = 0.5; #end
#ifndef (Radiosity) #declare Radiosity = 0; #end
global_settings {
  assumed_gamma 1
  #if (Radiosity)
    radiosity { count 400 error_bound 0.5 recursion_limit 4 }
  #end
  #ifdef (Glim) light_mesh { sky on } #end
}
#default { finish { ambient 0 diffuse Albedo } }

camera {
  location <1.6, 1.6, 0.6>
  look_at <6.5, 1.6, 9>
  right x * image_width / image_height
  angle 80
}
background { rgb <0.30, 0.42, 0.62> }
light_source { <-30, 60, -40>, rgb <1.7, 1.55, 1.3> parallel point_at <6, 0, 6> }

// The ground is 12 by 16; the court, 12 by 8, lies in front, the arcade and
// the room behind it.
#macro Walls()
  box { <-0.3, -0.3, -0.3>, <12.3, 0, 16.3> pigment { rgb <0.9, 0.8, 0.65> } }
  box { <-0.3, 0, -0.3>, <0, 4, 16.3> pigment { rgb <1, 0.75, 0.5> } }
  box { <12, 0, -0.3>, <12.3, 4, 16.3> pigment { rgb <1, 0.75, 0.5> } }
  box { <0, 0, -0.3>, <12, 4, 0> pigment { rgb <1, 0.75, 0.5> } }
  box { <0, 0, 16>, <12, 4, 16.3> pigment { rgb <1, 0.95, 0.9> } }
  // The roof over arcade and room.
  box { <0, 3.4, 8>, <12, 3.7, 16> pigment { rgb 1 } }
  #for (I, 0, 5)
    box {
      <0.8, 0, 8>, <1.2, 3.4, 8.4>
      translate 2 * I * x
      pigment { rgb <1, 0.95, 0.85> }
    }
  #end
  // The wall between them, with a door at x 7 to 8.4.
  box { <0, 0, 11>, <7, 3.4, 11.3> pigment { rgb <1, 0.85, 0.7> } }
  box { <8.4, 0, 11>, <12, 3.4, 11.3> pigment { rgb <1, 0.85, 0.7> } }
  box { <7, 2.3, 11>, <8.4, 3.4, 11.3> pigment { rgb <1, 0.85, 0.7> } }
  // A well.
  box { <4.2, 0, 4>, <5.8, 0.9, 5.6> pigment { rgb 0.9 } }
#end
Walls()

#ifdef (Points)
  #include "points.inc"
  #declare Void = array[3][2] {
    { <0.1, 1.0, 0.1>, <11.9, 3.3, 7.9> }
    { <0.1, 0.1, 8.5>, <11.9, 3.3, 10.9> }
    { <0.1, 0.1, 11.4>, <11.9, 3.3, 15.9> }
  }
  Write_Points("courtyard.points", union { Walls() }, Void, Points)
#end
