// A bright room and a dark one, side by side, and between them a wall of a
// hundredth of a room's size. No light passes; what is bright behind the wall
// must not be seen in front of it. The dark room has a lamp of its own, of a
// fiftieth of the light.
//   glim thinwall.pov +W400 +H300
//   Declare=View=1         the plan of both rooms, from under the ceiling
//   Declare=Faint=0        puts out the dark room's lamp: it must be black
//   Declare=Thickness=0.04 of the wall; a room is 4 by 4
//   Declare=Albedo=0.5, Declare=Radiosity=1, Declare=Points=160: as in room.pov
#version 3.7;
#ifndef (View) #declare View = 0; #end
#ifndef (Faint) #declare Faint = 0.02; #end
#ifndef (Thickness) #declare Thickness = 0.04; #end
#ifndef (Albedo) #declare Albedo = 0.5; #end
#ifndef (Radiosity) #declare Radiosity = 0; #end
global_settings {
  assumed_gamma 1
  #if (Radiosity)
    radiosity { count 400 error_bound 0.5 recursion_limit 4 }
  #end
}
#default { finish { ambient 0 diffuse Albedo } }

#if (View)
  camera {
    orthographic
    location <2, 2.69, 2>
    direction -y right 9*x up 9*z * image_height / image_width
    translate <2, 0, 0>
  }
#else
  camera {
    location <7.8, 1.5, 0.3>
    look_at <4, 1.1, 2.4>
    right x * image_width / image_height
    angle 75
  }
#end

#declare Light = <24, 23, 21>;
light_source { <2.6, 2.2, 2>, Light fade_distance 0.5 fade_power 2 }
#if (Faint > 0)
  light_source { <6, 2.2, 2>, Faint * Light fade_distance 0.5 fade_power 2 }
#end

#macro Walls()
  box { <-0.2, -0.2, -0.2>, <8.2, 0, 4.2> pigment { rgb <1, 0.9, 0.8> } }
  box { <-0.2, 2.7, -0.2>, <8.2, 2.9, 4.2> pigment { rgb 1 } }
  box { <-0.2, 0, -0.2>, <0, 2.7, 4.2> pigment { rgb 1 } }
  box { <8, 0, -0.2>, <8.2, 2.7, 4.2> pigment { rgb 1 } }
  box { <0, 0, -0.2>, <8, 2.7, 0> pigment { rgb 1 } }
  box { <0, 0, 4>, <8, 2.7, 4.2> pigment { rgb 1 } }
  box {
    <4 - Thickness / 2, 0, 0>, <4 + Thickness / 2, 2.7, 4>
    pigment { rgb 1 }
  }
  box { <5.4, 0, 2.8>, <6.2, 1, 3.6> pigment { rgb <0.6, 0.8, 1> } }
#end
Walls()

#ifdef (Points)
  #include "points.inc"
  // Only the dark room; but the first is the wall's bright side.
  #declare First_Point = concat(str(4 - Thickness / 2 - 0.001, 0, 5),
                                " 1.35 2 -1 0 0 bright");
  #declare Void = array[1][2] { { <4.1, 1.1, 0.1>, <7.9, 2.6, 3.9> } }
  Write_Points("thinwall.points", union { Walls() }, Void, Points)
#end
