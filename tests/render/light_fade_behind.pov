// A parallel light fades by its distance, which is negative behind its plane:
// with odd powers it is more than twice as bright there (2 here, which is white),
// then below nothing (black).
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right 24*x up 18*y look_at 0 }
#declare Power = 1;
#while (Power <= 4)
  light_group {
    light_source { <0, 1, -1>, rgb 1
      parallel point_at <1, 1, -1> fade_distance 4.3 fade_power Power }
    union {
      #declare I = -11;
      #while (I < 12)
        sphere { <I, 8 - 3*Power, 0>, .45 }
        #declare I = I + 1;
      #end
      pigment { rgb 1 } finish { diffuse 1 ambient 0 } no_shadow
    }
    global_lights on
  }
  #declare Power = Power + .5;
#end
