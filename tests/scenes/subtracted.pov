// Vectors without commas whose last component is negative have two; those that
// are meant to have two aren't warned of.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare I = 3;
camera { location <0 2 -6> look_at <0, 1 -1, 0> }
#declare Pair = <I - 1, I -1>;
#declare Other = <I - 1 I - 1>;
sphere { <1 2 3 >, 1 -0.5 }
