// Sphere sweeps: straight, through balls, near balls; one in CSG, one of glass,
// one whose first ball has the second one within it.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, .4, 0> angle 45 }
light_source { <-5, 8, -6>, 1 }
#default { pigment { rgb <.9, .6, .3> } finish { ambient .1 phong .4 } }
plane { y, -1 pigment { checker rgb .8 rgb .4 } }
difference {
    sphere_sweep { b_spline 25
        #for (I, 0, 24)
            <1.5 * sin(I * .7), I * .07 - .5, 1.5 * cos(I * .7)>,
            .12 + .04 * sin(I)
        #end
    }
    box { -2, <2, .3, -.3> }
}
sphere_sweep { linear_spline 3, <-2, 0, 1>, .2 <-2, 1, -1>, .4 <-1, 2, -1>, .1
    pigment { rgbt <.5, 1, .5, .5> } interior { ior 1.2 } }
sphere_sweep { cubic_spline 5, <-1, 0, 0>, .2, <0, 1, 0>, .3, <1, 0, 0>, .2,
    <1, 1, 1>, .1 <2, 1, 1>, .1 tolerance .01 rotate -40*y }
sphere_sweep { linear_spline 3, <2, -.4, -1.5>, .5, <2.2, -.4, -1.5>, .1,
    <3, -.4, -1.5>, .1 clipped_by { plane { y, -.3 } } }
