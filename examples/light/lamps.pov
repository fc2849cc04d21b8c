// A town at night under ten thousand lamps: what does light cost when every
// point of every wall could ask every lamp?
//   glim lamps.pov +W320 +H240 Declare=Lamps=1000
//   Declare=Lamps=10000    how many; the light of all together stays the same
#version 3.7;
#ifndef (Lamps) #declare Lamps = 10000; #end
global_settings {
  assumed_gamma 1
  #ifdef (Glim) light_mesh { sky on } #end
}
#default { finish { ambient 0 diffuse 0.8 } }

camera {
  location <-13, 11, -19>
  look_at <-0.5, 0, -1.5>
  right x * image_width / image_height
  angle 50
}
background { rgb <0.02, 0.03, 0.08> }
box { <-20, -0.2, -20>, <20, 0, 20> pigment { rgb <0.6, 0.58, 0.55> } }

// Houses in a grid of 14 by 14, streets between them.
#declare Seed = seed(3);
#for (X, 0, 13)
  #for (Z, 0, 13)
    #local Wide = 0.5 + 0.35 * rand(Seed);
    #local Deep = 0.5 + 0.35 * rand(Seed);
    #local Tall = 0.8 + 2.4 * rand(Seed) * rand(Seed);
    #local Hue = <0.6 + 0.4 * rand(Seed), 0.5 + 0.4 * rand(Seed),
                  0.4 + 0.4 * rand(Seed)>;
    union {
      box { <-Wide, 0, -Deep>, <Wide, Tall, Deep> }
      #if (rand(Seed) < 0.5)
        cylinder { Tall*y, (Tall + 0.3)*y, 0.4 * Wide }
      #else
        sphere { Tall*y, 0.6 * Wide }
      #end
      translate <2.4 * (X - 6.5), 0, 2.4 * (Z - 6.5)>
      pigment { rgb Hue }
    }
  #end
#end

// Lamps over the streets, 0.5 to 4 high.
#declare Dice = seed(11);
#for (I, 1, Lamps)
  #local Along = 36 * (rand(Dice) - 0.5);
  #local Across = 2.4 * (floor(15 * rand(Dice)) - 7) + 0.5 * (rand(Dice) - 0.5);
  light_source {
    #if (rand(Dice) < 0.5)
      <Along, 0.5 + 3.5 * rand(Dice), Across>
    #else
      <Across, 0.5 + 3.5 * rand(Dice), Along>
    #end
    rgb 250 / Lamps * <1, 0.6 + 0.3 * rand(Dice), 0.3 + 0.5 * rand(Dice)>
    fade_distance 0.7 fade_power 2
  }
#end
