// irid of what is mirrored: by the way that the light comes, which a steep bump
// does not send into the surface but along it.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 irid_wavelength rgb <.7, .5, .4> }
camera { location <0, 2, -10> look_at <0, -1, 0> angle 75 }
light_source { <0, 60, -200>, 1 }
sky_sphere { pigment { rgb .5 } }
plane { y, 0
    pigment { rgb <0, .6, 0> }
    normal { ripples .4 scale 3 }
    finish { irid { .4 thickness .3 } reflection .8 } }
// What passes is dimmed by what the mirror is without its film.
sphere { <-2, 1.6, -5>, 1
    pigment { rgbt <1, .9, .8, .9> }
    finish { irid { .4 thickness .3 } reflection .6 conserve_energy } }
// The film tints what the exponent is applied to.
sphere { <1.5, 1.6, -5>, 1
    pigment { rgb <.2, .3, .8> }
    finish { irid { .4 thickness .3 } reflection { .6 exponent 1.4 } } }
