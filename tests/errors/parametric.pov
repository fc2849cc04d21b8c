#version 3.7;
parametric { function { u } function { v } <0, 0>, <1, 1> }
parametric { function { u } function { v } function(a, b, c, d) { u } <0, 0>, <1, 1> }
parametric { function { u } function { v } function { u } <0, 0>, <1, 1e400> }
parametric { function { sum(i, 1, 1e9, u * i) } function { v } function { u } <0, 0>, <1, 1> }
parametric { function { u } function { v } function { u } <0, 0>, <1, 1> contained_by { sphere { 0, 0 } } }
parametric { function { u } function { v } function { u } <0, 0>, <1, 1> open }
