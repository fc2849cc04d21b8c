// After "Constructive Wood", the scene that the paper's meshes drew wrong: all
// that is seen here is painted white. The backs of the slats are painted, and
// lit from behind; no side of a slat sees a painted one: its colour comes by
// way of the wall, which sees both.
//   glim wood.pov --lighting mesh
//   Declare=Letter=1       --lighting paper, its formulas to the letter
//   Declare=Radiosity=1    POV-Ray's radiosity
#version 3.7;
#ifndef (Letter) #declare Letter = 0; #end
#ifndef (Radiosity) #declare Radiosity = 0; #end
global_settings {
  assumed_gamma 1
  #if (Radiosity)
    radiosity { count 400 error_bound 0.4 recursion_limit 4 }
  #end
  #ifdef (Glim)
    light_mesh {
      #if (Letter) model scalar interpolation spherical #end
      indirect on
    }
  #end
}
#default { finish { ambient 0 diffuse 0.75 } }

camera {
  location <0.5, 1.7, -4.6>
  look_at <0, 1, 0>
  right x * image_width / image_height
  angle 56
}

// A white room.
difference {
  box { <-2.7, -0.2, -5.2>, <2.7, 2.4, 1.2> }
  box { <-2.5, 0, -5>, <2.5, 2.2, 1> }
  pigment { rgb 1 }
}

// A thick slat: all sides white but the back. Its lamps are spots in the
// wall that light nothing but backs.
#macro Slat(X, Paint)
  box { <X - 0.28, 0, 0>, <X + 0.28, 2.2, 0.38> pigment { rgb 1 } }
  box { <X - 0.28, 0, 0.38>, <X + 0.28, 2.2, 0.4> pigment { rgb Paint } }
  #for (Y, 0.35, 1.85, 0.75)
    light_source {
      <X, Y, 0.98>, #if (Letter) 1.7 #else 6 #end
      spotlight point_at <X, Y, 0> radius 18 falloff 25
    }
  #end
#end
Slat(-2.0, <0.9, 0.15, 0.1>)
Slat(-1.0, <0.9, 0.6, 0.08>)
Slat(0, <0.2, 0.7, 0.15>)
Slat(1.0, <0.1, 0.4, 0.9>)
Slat(2.0, <0.55, 0.15, 0.75>)
