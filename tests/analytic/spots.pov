// Thirty spotlights before a wall, more lamps than are asked one by one if they
// light everything. Each has a cone of 3 degrees with a sharp edge, 10 before the
// wall: a disc of radius .524, whose middle has pigment * diffuse = .7, and none
// between the discs, .707 from four middles. A row of middles is at y = 0. Parallel
// light, which keeps lamps from being summed by pixels, adds .07 everywhere.
// claims: rays mesh
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse .7 } }
light_source { -10*z rgb .1 parallel point_at 0 }
#for (I, -2.5, 2.5)
  #for (J, -2, 2)
    light_source {
      <I, J, -10> rgb 1
      spotlight point_at <I, J, 0> radius 3 falloff 3 tightness 0
    }
  #end
#end
