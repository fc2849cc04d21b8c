#version 3.7; global_settings{assumed_gamma 1}
camera{orthographic location <0,0,-10> right 1*x up 1*y direction z}
background{rgb 1}
plane{-z,0 texture{ gradient x texture_map{[0 pigment{rgb 0} finish{ambient 0 diffuse 0 reflection 0.9}][1 pigment{rgb 0} finish{ambient 0 diffuse 0 reflection 0}]} scale 100 translate -0.5*100*x}}
