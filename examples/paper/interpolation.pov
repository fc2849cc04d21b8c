// The paper's figure 2: a coarse light mesh under a table of things. `nearest`
// shows its cells, `spherical` smooths them; see README.md.
//   glim interpolation.pov --lighting mesh --mesh-interpolation nearest
//   Declare=Letter=1       --lighting paper, its formulas to the letter
#version 3.7;
#ifndef (Letter) #declare Letter = 0; #end
global_settings {
  assumed_gamma 1
  #ifdef (Glim)
    light_mesh {
      density 3
      shadows soft indirect off
      #if (Letter) model scalar #end
    }
  #end
}
#default { finish { ambient 0 diffuse 0.8 } }

camera {
  location <0, 3.6, -5.2>
  look_at <0, 0.55, 0>
  right x * image_width / image_height
  angle 52
}

// Four lamps. To the letter light is E^2 / (1 + r)^2, of all lamps together.
#macro Lamp(Where, Colour)
  light_source { Where, Colour * #if (Letter) 6.5 #else 1 #end }
#end
Lamp(<-4, 5, -3>, <0.46, 0.42, 0.36>)
Lamp(<4, 5, -2>, <0.34, 0.36, 0.40>)
Lamp(<-1, 6, 4>, <0.26, 0.26, 0.28>)
Lamp(<2, 4, -6>, <0.18, 0.17, 0.16>)

box { <-6, -0.1, -6>, <6, 0, 3> pigment { rgb <0.85, 0.82, 0.75> } }
box { <-6, 0, 3>, <6, 4, 3.1> pigment { rgb <0.7, 0.78, 0.85> } }
sphere { <-1.3, 0.75, 0>, 0.75 pigment { rgb <0.85, 0.4, 0.3> } }
cylinder { <0.4, 0, 1>, <0.4, 1.7, 1>, 0.4 pigment { rgb <0.5, 0.7, 0.4> } }
box {
  <-0.5, 0, -0.5>, <0.5, 0.9, 0.5>
  rotate 25*y translate <1.5, 0, -0.4>
  pigment { rgb <0.9, 0.75, 0.35> }
}
torus {
  0.45, 0.16
  translate <0, 0.16, -1.3>
  pigment { rgb <0.5, 0.45, 0.75> }
}
