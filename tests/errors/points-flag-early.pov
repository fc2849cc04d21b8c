// What modifies a shape of points comes behind them.
prism { open 0, 1, 5 <0,0>, <1,0>, <1,1>, <0,1>, <0,0> }
prism { 0, 1, 5 open <0,0>, <1,0>, <1,1>, <0,1>, <0,0> }
lathe { linear_spline sturm 2 <0,0>, <1,1> }
prism { 0, 1, 5 <0,0>, <1,0>, <1,1> open }
