// Four rooms in a ring, open at one place. Only the first (red) and the last
// (blue) have a lamp; the two white ones between see neither lamp, and most of
// their walls see no coloured wall: the colour comes round the corners, from
// white wall to white wall. Seen from the second room.
//       D blue, lamp | C white
//       -------------+---  --    doors: A to B, B to C, C to D
//       A red, lamp    B white
//   glim blocks.pov +W400 +H300 --lighting path
//   Declare=View=1         the plan, from just under the ceiling
//   Declare=Albedo=0.5     how much of the light the brightest walls give back
//   Declare=Radiosity=1    POV-Ray's radiosity, glim's indirect light mesh
//   Declare=Points=160     writes blocks.points (points.inc)
#version 3.7;
#ifndef (View) #declare View = 0; #end
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
    location <3.5, 2.69, 2>
    direction -y right 9*x * image_width / image_height up 9*z
    translate <0.6, 0, 2.1>
  }
#else
  camera {
    location <7.9, 1.6, 0.3>
    look_at <5.9, 1.2, 3.2>
    right x * image_width / image_height
    angle 85
  }
#end

light_source { <1.6, 2.2, 1.6>, <48, 44, 40> fade_distance 0.5 fade_power 2 }
light_source { <1.6, 2.2, 6.4>, <40, 44, 48> fade_distance 0.5 fade_power 2 }

#declare White = pigment { rgb 1 }
#declare Red = pigment { rgb <1, 0.12, 0.08> }
#declare Blue = pigment { rgb <0.10, 0.24, 1> }
#macro Walls()
  // Floor and ceiling, coloured in A and D.
  #local Level = -0.2;
  #while (Level < 3)
    box { <-0.2, Level, -0.2>, <4.1, Level + 0.2, 4.1> pigment { Red } }
    box { <-0.2, Level, 4.1>, <4.1, Level + 0.2, 8.4> pigment { Blue } }
    box { <4.1, Level, -0.2>, <8.4, Level + 0.2, 8.4> pigment { White } }
    #local Level = Level + 2.9;
  #end
  // The outer walls.
  box { <-0.2, 0, -0.2>, <4.1, 2.7, 0> pigment { Red } }
  box { <-0.2, 0, 0>, <0, 2.7, 4.1> pigment { Red } }
  box { <-0.2, 0, 4.1>, <0, 2.7, 8.2> pigment { Blue } }
  box { <-0.2, 0, 8.2>, <4.1, 2.7, 8.4> pigment { Blue } }
  box { <4.1, 0, 8.2>, <8.4, 2.7, 8.4> pigment { White } }
  box { <8.2, 0, 0>, <8.4, 2.7, 8.2> pigment { White } }
  box { <4.1, 0, -0.2>, <8.4, 2.7, 0> pigment { White } }
  // Between A and D, closed.
  box { <0, 0, 4>, <4, 2.7, 4.1> pigment { Red } }
  box { <0, 0, 4.1>, <4, 2.7, 4.2> pigment { Blue } }
  // Between A and B: two skins, a door at z 0.4 to 1.4.
  #local Skin = 4;
  #while (Skin < 4.15)
    union {
      box { <Skin, 0, 0>, <Skin + 0.1, 2.7, 0.4> }
      box { <Skin, 2.1, 0.4>, <Skin + 0.1, 2.7, 1.4> }
      box { <Skin, 0, 1.4>, <Skin + 0.1, 2.7, 4.1> }
      #if (Skin < 4.05) pigment { Red } #else pigment { White } #end
    }
    // Between D and C: a door at z 6.8 to 7.8.
    union {
      box { <Skin, 0, 4.1>, <Skin + 0.1, 2.7, 6.8> }
      box { <Skin, 2.1, 6.8>, <Skin + 0.1, 2.7, 7.8> }
      box { <Skin, 0, 7.8>, <Skin + 0.1, 2.7, 8.2> }
      #if (Skin < 4.05) pigment { Blue } #else pigment { White } #end
    }
    #local Skin = Skin + 0.1;
  #end
  // Between B and C: a door at x 5.6 to 6.8.
  union {
    box { <4.2, 0, 4>, <5.6, 2.7, 4.2> }
    box { <5.6, 2.1, 4>, <6.8, 2.7, 4.2> }
    box { <6.8, 0, 4>, <8.2, 2.7, 4.2> }
    pigment { White }
  }
  // A block in each white room, so that there are corners to find.
  box {
    <-0.4, 0, -0.4>, <0.4, 1.1, 0.4>
    rotate 30*y translate <5.2, 0, 2.7>
    pigment { White }
  }
  box {
    <-0.5, 0, -0.5>, <0.5, 1.6, 0.5>
    rotate -15*y translate <7.2, 0, 6.9>
    pigment { White }
  }
#end
Walls()

#ifdef (Points)
  #include "points.inc"
  #declare Void = array[4][2] {
    { <0.1, 0.1, 0.1>, <3.9, 2.6, 3.9> }
    { <4.3, 1.2, 0.1>, <8.1, 2.6, 3.9> }
    { <4.3, 1.7, 4.3>, <8.1, 2.6, 8.1> }
    { <0.1, 0.1, 4.3>, <3.9, 2.6, 8.1> }
  }
  Write_Points("blocks.points", union { Walls() }, Void, Points)
#end
