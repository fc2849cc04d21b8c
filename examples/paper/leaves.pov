// The paper's figures 4 and 5: leaves of a forest, and three lamps just above
// the trees; soft shadows by light meshes, sharp ones by shadow rays.
//   glim leaves.pov --lighting mesh
//   Declare=Leaves=450     of each tree
//   Declare=Letter=1       --lighting paper, its formulas to the letter
#version 3.7;
#ifndef (Leaves) #declare Leaves = 450; #end
#ifndef (Letter) #declare Letter = 0; #end
global_settings {
  assumed_gamma 1
  #ifdef (Glim)
    light_mesh {
      density 6
      shadows soft indirect off
      interpolation spherical
      #if (Letter) model scalar #end
    }
  #end
}
#default { finish { ambient 0 diffuse 0.8 } }

camera {
  location <0, 4.2, -8.4>
  look_at <0, 1.3, 0>
  right x * image_width / image_height
  angle 48
}
background { rgb <0.10, 0.13, 0.18> }

// Three lamps. To the letter light is E^2 / (1 + r)^2, of all lamps together.
#macro Lamp(Where, Colour)
  light_source { Where, Colour * #if (Letter) 5 #else 1 #end }
#end
Lamp(<-2.2, 4.4, -1.0>, <0.55, 0.50, 0.40>)
Lamp(<0.6, 4.6, 1.6>, <0.40, 0.40, 0.38>)
Lamp(<2.6, 4.3, -1.4>, <0.45, 0.45, 0.50>)

box { <-9, -0.1, -9>, <9, 0, 7> pigment { rgb <0.80, 0.74, 0.60> } }

#declare Dice = seed(11);
#macro Between(Low, High) (Low + (High - Low) * rand(Dice)) #end
#macro Tree(Where, Tall)
  cone { Where, 0.09, Where + Tall * 1.1 * y, 0.02
         pigment { rgb <0.45, 0.32, 0.2> } }
  mesh {
    #for (I, 1, Leaves)
      #local Turn = 2 * pi * rand(Dice);
      #local Up = Between(-1, 1);
      #local Reach = 0.9 * pow(rand(Dice), 0.4);
      #local Flat = Reach * sqrt(1 - Up * Up);
      #local Leaf = Where + <Flat * cos(Turn), Tall + 1.2 * Reach * Up,
                             Flat * sin(Turn)>;
      triangle {
        Leaf
        Leaf + <Between(-0.2, 0.2), Between(-0.1, 0.1), Between(-0.2, 0.2)>
        Leaf + <Between(-0.2, 0.2), Between(-0.1, 0.1), Between(-0.2, 0.2)>
      }
    #end
    pigment { rgb <Between(0.25, 0.5), Between(0.5, 0.65), 0.2> }
  }
#end
Tree(<-2.9, 0, 0.2>, 1.9)
Tree(<-1.2, 0, 1.9>, 2.1)
Tree(<-0.3, 0, -0.5>, 1.8)
Tree(<1.3, 0, 0.9>, 2.2)
Tree(<2.9, 0, 0.0>, 1.9)
Tree(<3.3, 0, 2.9>, 2.2)
Tree(<-3.6, 0, 3.1>, 2.1)
