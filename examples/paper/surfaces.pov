// The paper's figure 3: light meshes under mirroring surfaces and, the same
// things, dull ones; see README.md.
//   glim surfaces.pov --lighting mesh
//   Declare=Dull=1         everything dull
//   Declare=Letter=1       --lighting paper, its formulas to the letter
#version 3.7;
#ifndef (Dull) #declare Dull = 0; #end
#ifndef (Letter) #declare Letter = 0; #end
global_settings {
  assumed_gamma 1
  #ifdef (Glim)
    light_mesh {
      density 5
      shadows soft indirect off
      #if (Letter) model scalar interpolation spherical #end
    }
  #end
}
#default { finish { ambient 0 diffuse 0.8 } }

camera {
  location <0, 2.6, -6>
  look_at <0, 0.9, 0>
  right x * image_width / image_height
  angle 48
}

// Three lamps. To the letter light is E^2 / (1 + r)^2, of all lamps together.
#macro Lamp(Where, Colour)
  light_source { Where, Colour * #if (Letter) 6.5 #else 1 #end }
#end
Lamp(<-4, 6, -4>, <0.50, 0.46, 0.40>)
Lamp(<5, 5, -3>, <0.36, 0.38, 0.42>)
Lamp(<-1, 7, 2>, <0.26, 0.26, 0.28>)

#macro Surface(Colour)
  pigment { rgb Colour }
  #if (!Dull)
    finish { diffuse 0.45 reflection 0.45 specular 0.6 roughness 0.02 }
  #end
#end
box { <-8, -0.1, -8>, <8, 0, 4> pigment { checker rgb <0.85, 0.8, 0.7> rgb <0.45, 0.5, 0.6> } }
box { <-8, 0, 4>, <8, 5, 4.1> pigment { rgb <0.7, 0.75, 0.8> } }
sphere { <-1.5, 1, 0.4>, 1 Surface(<0.9, 0.35, 0.25>) }
sphere { <1.3, 0.7, -0.8>, 0.7 Surface(<0.3, 0.55, 0.85>) }
cone { <0.6, 0, 1.8>, 0.9, <0.6, 2.2, 1.8>, 0.25 Surface(<0.9, 0.8, 0.4>) }
sphere { <-0.3, 0.35, -1.4>, 0.35 Surface(<0.5, 0.8, 0.45>) }
