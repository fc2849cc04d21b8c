prism { quadratic_spline 0, 1, 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <2, 2> }
prism { cubic_spline 0, 1, 3, <0, 0>, <1, 0>, <1, 1> }
lathe { bezier_spline 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 2> }
lathe { quadratic_spline 2, <0, 0>, <1, 0> }
