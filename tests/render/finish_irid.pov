// irid: colours of thin films on a plane and on balls, thicker here than there,
// over a highlight, under several lamps, with wavelengths of their own.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 irid_wavelength rgb <.6, .5, .4> }
camera { location <0, 3, -5> right 4/3*x look_at <0, .5, 0> angle 50 }
light_source { <-4, 6, -5>, rgb .7 }
light_source { <5, 3, -2>, rgb .4 }
plane { y, -.5 pigment { rgb .7 } finish { irid { .35 thickness .8 turbulence .4 } } }
sphere { <-1.5, .5, 0>, 1 pigment { rgb <.9, .6, .3> }
    finish { phong .5 irid { .5 thickness .3 } } }
sphere { <1.2, .5, 0>, 1 pigment { rgb .5 } normal { bumps .4 scale .2 }
    finish { specular .5 reflection .2 irid { .8 thickness 2 turbulence .1 } } }
sphere { <0, 0, -1.6>, .5 pigment { rgb 1 } finish { diffuse .6 irid { .4 } } }
