// sor: through points by height, open, cut.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <-3, 4, -6>, 1 }
#default { pigment { rgb .9 } finish { ambient .1 diffuse .7 phong .4 } }
sor { 7, <0, -1.3>, <.5, -1.2>, <1, -.7>, <.4, .1>, <.3, .6>, <.8, 1.1>, <1, 1.3>
    rotate -20*x scale .55 translate -1.3*x }
sor { 7, <0, -1.3>, <.5, -1.2>, <1, -.7>, <.4, .1>, <.3, .6>, <.8, 1.1>, <1, 1.3> open
    rotate <-40, 0, 20> scale .55 }
difference { sor { 6, <0, -1.3>, <.5, -1.2>, <1, -.7>, <.4, .1>, <.8, 1.1>, <1, 1.3> sturm }
    box { <0, -2, -2>, 2 } rotate <-20, 30, 0> scale .55 translate 1.3*x }
