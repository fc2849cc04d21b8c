// Normals of all kinds on balls.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,6,-8> look_at <0,0,0.4> angle 45 }
light_source { <-6, 5, -3> rgb 1 }
#declare K = 0;
#macro Put(Nn) sphere { 0, 0.48 pigment { rgb <.8,.7,.6> } finish { specular 0.6 roughness 0.02 } normal { Nn } translate <mod(K,6)-2.5, 0, 1.5-int(K/6)> } #declare K = K + 1; #end
Put(normal { bumps 0.6 scale 0.1 })
Put(normal { dents 0.8 scale 0.2 })
Put(normal { granite 0.4 scale 0.5 accuracy 0.01 })
Put(normal { gradient x 0.5 sine_wave scale 0.2 slope_map { [0 <0,1>] [0.5 <1,1>] [0.5 <1,-1>] [1 <0,-1>] } })
Put(normal { ripples 0.7 scale 0.1 })
Put(normal { waves 0.7 scale 0.1 })
Put(normal { wrinkles 0.8 scale 0.1 })
Put(normal { quilted 1 control0 1 control1 0 scale 0.2 })
Put(normal { facets coords 0.2 })
Put(normal { facets size 0.3 })
Put(normal { brick 0.5 scale 0.03 })
Put(normal { checker 1 scale 0.1 })
Put(normal { crackle 0.7 scale 0.2 turbulence 0.2 })
Put(normal { radial 0.6 frequency 10 })
Put(normal { onion 0.6 scale 0.05 })
Put(normal { average normal_map { [1 bumps 1 scale 0.1] [1 wrinkles 2 scale 0.2] } })
Put(normal { marble 1 normal_map { [0 bumps scale 0.1] [1 dents 1 scale 0.1] } scale 0.3 })
Put(normal { function { sin(x*30)*0.2 } 0.8 })
Put(normal { bump_map { png "bumpmap_.png" map_type 1 bump_size 4 } })
Put(normal { pigment_pattern { checker scale 0.2 } 0.5 })
Put(normal { spiral1 4 0.5 scale 0.1 })
Put(normal { cells 0.5 scale 0.1 })
Put(normal { leopard -0.6 scale 0.02 })
plane { y, -0.5 pigment { rgb .6 } normal { agate 0.3 scale 0.5 } }
