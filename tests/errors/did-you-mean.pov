#declare Radius = 1;
sphere { <0,0,0>, Raduis }
