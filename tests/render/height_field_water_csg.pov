// A height field under water is inside all the same.
// compare: exact
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,1,-7> look_at <0,-0.5,0> angle 45 }
light_source { <-5,8,-6> rgb 1 }

intersection { cylinder { -3*y,3*y,1 } height_field { png "plasma2.png" water_level 0.5 translate <-0.5,0,-0.5> scale <6,2,6> } pigment { rgb x } }
