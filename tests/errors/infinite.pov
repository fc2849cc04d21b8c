sphere { <1/0, 0, 0>, 1 }
sphere { 0, 1/0 }
box { 0, 1 translate x/0 }
