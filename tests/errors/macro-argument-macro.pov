#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
light_source { -9*z rgb 1 }
#macro Pg() bozo turbulence .5 #end
#macro Tile(P, A) box { -1, 1 pigment { P } } #end
Tile(Pg(), 3)
