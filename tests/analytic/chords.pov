// How long a ray is inside a solid, read from the light glass absorbs:
// fade_power 1001 gives exp(-(1 - fade_color) * length/fade_distance), here
// exp(-length) in red and exp(-length/2) in green, before a wall that glows 1.
// claims: rays mesh soft
//
// Lengths along z:
//   a sphere of radius 1: at its centre 2, at .6 from it 2 * .8 = 1.6;
//   the same less a sphere of radius .5: 1 at the centre, 1.6 at .6,
//     and at .3: 2 sqrt .91 - 2 * .4 = 1.107878;
//   unit spheres .5 before and .5 behind, intersected: at the centre
//     2 * (1 - .5) = 1, at .6 from it 2 * (.8 - .5) = .6;
//   a torus of radii .7 and .3 facing the view: through the middle of the tube
//     .6, at .8 from the centre 2 sqrt(.09 - .01) = .565685, in the hole 0;
//   a cone from radius .8 to 0, axis up: at half its height .8 on the axis,
//     at .2 off it 2 sqrt(.16 - .04) = .692820;
//   spheres of radius .4 at z = -.5 and .2 merged with a cylinder of radius .5
//     along x: on the axis from -.9 to .6 = 1.5; at y = .3: the spheres reach
//     sqrt .07 = .264575, so -.764575 ... -.235425 and -.064575 ... .464575,
//     the cylinder -.4 ... .4, together -.764575 ... .464575 = 1.229150;
//     at x = .5, y = .3: the cylinder alone, 2 * .4 = .8.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
plane { -z, -5 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }
#declare Glass = material {
    texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
    interior { fade_distance 1 fade_power 1001 fade_color <0, .5, 1> }
}
sphere { 0, 1 material { Glass } translate <-2.1, 1.2, 0> }
difference { sphere { 0, 1 } sphere { 0, .5 }
    material { Glass } translate <0, 1.2, 0> }
intersection { sphere { -.5*z, 1 } sphere { .5*z, 1 }
    material { Glass } translate <2.1, 1.2, 0> }
torus { .7, .3 rotate 90*x material { Glass } translate <-2.1, -1.2, 0> }
cone { <0, -2, 0>, .8, <0, -.4, 0>, 0 material { Glass } }
merge { sphere { -.5*z, .4 } sphere { .2*z, .4 } cylinder { -.6*x, .6*x, .5 }
    material { Glass } translate <2.1, -1.2, 0> }
