sphere { 0, 1 pigment { wood warp { repeat <1, 1, 0> } } }
sphere { 0, 1 pigment { wood warp { repeat x ofset y } } }
sphere { 0, 1 pigment { wood warp { black_hole 0 } } }
sphere { 0, 1 pigment { wood warp { black_hole 0, 1 turbulence .5 } } }
sphere { 0, 1 pigment { wood warp { displace } } }
sphere { 0, 1 pigment { wood warp { toroidal orientation 0 } } }
sphere { 0, 1 pigment { wood warp { spherical major_radius 2 } } }
sphere { 0, 1 pigment { wood #for (I, 1, 1001) warp { repeat x } #end } }
