// irid of a surface that is lit from behind.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 irid_wavelength rgb <.9, .7, .5> }
camera { location <0, 0, -5> look_at 0 angle 50 }
light_source { <3, 4, 5>, 1 }
disc { 0, -z, 2 pigment { rgb 1 }
    finish { ambient 0 diffuse .1, .8 irid { .6 thickness 1.2 } } }
