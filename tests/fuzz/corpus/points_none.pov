// No points: nothing to make smaller.
prism { 0, 1, 0 }
lathe { linear_spline 0 }
polygon { 0 }
