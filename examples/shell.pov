// A sea shell: mesh2 with points, normals and faces computed in loops. A tube
// whose radius grows with every turn of a spiral; the normals are crossed from
// differences, so that the shell is smooth.
//   glim shell.pov +W800 +H500 +A
//   glim shell.pov +W800 +H500 +A Declare=Around=20    (see the triangles)
#version 3.7;
global_settings { assumed_gamma 1 }

#ifndef (Around) #declare Around = 60; #end
#declare Turns = 7;
#declare Along = int(Around * Turns * 1.2);

camera {
  location <0.5, 4.2, -8.2>
  look_at <0, 0.85, 0>
  right x * image_width / image_height
  angle 36
}
light_source { <7, 8, -5> rgb <1.35, 1.18, 0.92> }
light_source { <-8, 6, -6> rgb <0.14, 0.20, 0.30> shadowless }
background { rgb <0.60, 0.75, 0.85> }

// The point at turn U and angle V around the tube. Ribs and spines are added
// to the tube's radius.
#macro Shell(U, V)
  #local Grow = exp(0.085 * (U - 2 * pi * Turns));
  #local Rib = 1 + 0.035 * pow(abs(sin(U * 5)), 3);
  #local Tube = 0.78 * Grow * Rib;
  #local Out = Grow * 0.72 + Tube * cos(V);
  (<Out * cos(U), 3.5 * (1 - Grow) + Tube * 1.1 * sin(V), Out * sin(U)>)
#end
#macro ShellNormal(U, V)
  #local Step = 0.002;
  vnormalize(vcross(Shell(U, V + Step) - Shell(U, V - Step),
                    Shell(U + Step, V) - Shell(U - Step, V)))
#end
#macro TurnOf(I) (2 * pi * Turns * I / Along) #end
#macro AngleOf(J) (2 * pi * J / Around) #end

mesh2 {
  vertex_vectors {
    (Along + 1) * Around
    #for (I, 0, Along)
      #for (J, 0, Around - 1) , Shell(TurnOf(I), AngleOf(J)) #end
    #end
  }
  normal_vectors {
    (Along + 1) * Around
    #for (I, 0, Along)
      #for (J, 0, Around - 1) , ShellNormal(TurnOf(I), AngleOf(J)) #end
    #end
  }
  face_indices {
    2 * Along * Around
    #for (I, 0, Along - 1)
      #for (J, 0, Around - 1)
        #local A = I * Around + J;
        #local B = I * Around + mod(J + 1, Around);
        , <A, B, A + Around>, <B, B + Around, A + Around>
      #end
    #end
  }
  texture {
    pigment {
      wood
      color_map {
        [0.00 rgb <0.96, 0.80, 0.62>]
        [0.40 rgb <0.90, 0.58, 0.38>]
        [0.60 rgb <0.96, 0.86, 0.72>]
        [0.85 rgb <0.66, 0.32, 0.18>]
        [1.00 rgb <0.96, 0.80, 0.62>]
      }
      turbulence 0.12
      scale 0.45
      rotate 90*x
    }
    finish {
      ambient 0.16 diffuse 0.7
      specular 0.35 roughness 0.03 reflection { 0.01, 0.10 }
    }
  }
  rotate <0, 215, 0>
  rotate <0, 0, 72>
  rotate -28*y
  scale 0.95
  translate <1.35, 1.16, -0.6>
}

// Wet sand with ripples; the sea is a thin sheet at the back.
plane {
  y, 0
  pigment {
    bozo
    color_map { [0.2 rgb <0.62, 0.48, 0.32>] [0.8 rgb <0.74, 0.60, 0.42>] }
    turbulence 0.4
    scale 0.6
  }
  normal { granite 0.25 scale 0.4 }
  finish { ambient 0.15 diffuse 0.7 }
}
box {
  <-60, -0.1, 3.2>, <60, 0.02, 400>
  pigment { rgbf <0.55, 0.82, 0.84, 0.55> }
  normal { waves 0.18 scale <2.2, 1, 0.7> }
  finish { ambient 0.05 diffuse 0.35 reflection { 0.05, 0.7 } phong 0.6 }
  rotate -5*y
}
// Pebbles.
#declare Seed = seed(8);
#for (I, 1, 46)
  #local Grey = 0.15 + 0.45 * rand(Seed);
  sphere {
    0, 0.05 + 0.09 * pow(rand(Seed), 2)
    scale <1.3, 0.6, 1>
    rotate 360 * rand(Seed) * y
    translate <8 * rand(Seed) - 4, 0.02, 6.6 * rand(Seed) - 3.6>
    pigment { rgb Grey * <1, 0.95, 0.9> }
    finish { ambient 0.12 diffuse 0.7 phong 0.3 }
  }
#end
