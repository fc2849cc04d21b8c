// A hall of columns with hundreds of lamps that fade with distance: nearly
// every lamp is behind a column for somebody. Direct light only, no noise, so
// that pictures can be compared pixel by pixel.
//   glim hall.pov +W480 +H320
//   Declare=Lamps=240      how many; the light of all together stays the same
#version 3.7;
#ifndef (Lamps) #declare Lamps = 240; #end
global_settings { assumed_gamma 1 }
#default { finish { ambient 0 diffuse 0.8 } }

camera {
  location <0.7, 1.8, 0.5>
  look_at <0.2, 2.3, 12>
  right x * image_width / image_height
  angle 75
}

// Floor, walls and vault: 12 by 6 by 30.
box { <-6.3, -0.3, -0.3>, <6.3, 0, 30.3> pigment { rgb <0.75, 0.6, 0.5> } }
box { <-6.3, 6, -0.3>, <6.3, 6.3, 30.3> pigment { rgb <0.8, 0.82, 0.9> } }
box { <-6.3, 0, -0.3>, <-6, 6, 30.3> pigment { rgb <0.8, 0.75, 0.65> } }
box { <6, 0, -0.3>, <6.3, 6, 30.3> pigment { rgb <0.8, 0.75, 0.65> } }
box { <-6, 0, 30>, <6, 6, 30.3> pigment { rgb <0.85, 0.8, 0.7> } }
box { <-6, 0, -0.3>, <6, 6, 0> pigment { rgb <0.85, 0.8, 0.7> } }

#declare Column = union {
  box { <-0.5, 0, -0.5>, <0.5, 0.3, 0.5> }
  torus { 0.38, 0.1 translate 0.4*y }
  cone { 0.3*y, 0.38, 4.6*y, 0.30 }
  cone { 4.5*y, 0.30, 4.9*y, 0.52 }
  box { <-0.55, 4.9, -0.55>, <0.55, 5.2, 0.55> }
  pigment { rgb <0.9, 0.87, 0.8> }
}
#for (I, 0, 9)
  object { Column translate <-3, 0, 1.5 + 3 * I> }
  object { Column translate <3, 0, 1.5 + 3 * I> }
#end
#for (Side, -1, 1, 2)
  difference {
    box { <-0.45, 5.2, 0>, <0.45, 6, 30> translate 3 * Side * x }
    #for (I, 0, 8)
      cylinder { <-9, 5.0, 3 + 3 * I>, <9, 5.0, 3 + 3 * I>, 0.7 }
    #end
    pigment { rgb <0.9, 0.87, 0.8> }
  }
#end

// Lamps in even steps along five lines, each a little out of line.
#declare Seed = seed(7);
#declare Lines = array[5] { -5.4, -3, 0, 3, 5.4 }
#for (I, 0, Lamps - 1)
  #local Line = mod(I, 5);
  light_source {
    <Lines[Line] + 0.5 * (rand(Seed) - 0.5),
     #if (mod(Line, 2)) 5.5 #else 3.6 #end + 0.4 * rand(Seed),
     29.4 * (I + 0.5) / Lamps + 0.3>
    rgb 240 / Lamps * 0.14 * <1, 0.6 + 0.3 * rand(Seed), 0.4 + 0.4 * rand(Seed)>
    fade_distance 1.5 fade_power 2
  }
#end
