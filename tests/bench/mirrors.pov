// Bench: a box of mirror and glass balls; rays split and bounce up to 12 times.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
#ifndef (Side) #declare Side = 6; #end

camera {
  location <0.5, 4.2, -9>
  look_at <0, 0.9, 0>
  right x * image_width / image_height
  angle 42
}
light_source { <-6, 9, -7> rgb 0.9 }
light_source { <7, 8, -2> rgb <0.4, 0.45, 0.6> }
sky_sphere {
  pigment {
    gradient y
    color_map { [0 rgb <0.9, 0.75, 0.6>] [0.5 rgb <0.2, 0.35, 0.65>] }
  }
}
plane {
  y, 0
  pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.15, 0.12, 0.10> }
  finish { reflection 0.15 }
}
// Two mirrors face each other across the balls.
box {
  <-5.2, 0, -3>, <-5, 3, 4>
  pigment { rgb 0.05 } finish { diffuse 0.1 reflection 0.85 }
}
box {
  <5, 0, -3>, <5.2, 3, 4>
  pigment { rgb 0.05 } finish { diffuse 0.1 reflection 0.85 }
}
#for (X, 1, Side)
  #for (Z, 1, Side)
    #local Middle = (Side + 1) / 2;
    #local Where = <1.3 * (X - Middle), 0.6, 1.3 * (Z - Middle)>;
    #if (mod(X + Z, 2))
      sphere {
        Where, 0.58
        pigment { rgb 0.04 }
        finish { diffuse 0.2 reflection 0.8 phong 0.8 phong_size 120 }
      }
    #else
      sphere {
        Where, 0.58
        pigment { rgbf <0.95, 0.98, 0.97, 0.95> }
        finish {
          diffuse 0.05 reflection { 0, 1 fresnel } conserve_energy
          specular 0.6 roughness 0.004
        }
        interior { ior 1.5 }
      }
    #end
  #end
#end
