// A fog on the ground that says no height in which it thins out.
#version 3.7;
global_settings { assumed_gamma 1 }
fog { fog_type 2 distance 10 rgb 1 }
fog { fog_type 2 distance 10 rgb 1 fog_alt 1 }
