// The reflection block at one angle: a + (b - a)(1 - cos)^k; fresnel;
// exponent; metallic.
// claims: rays path mesh soft
//
// Mirrors in the plane turned by 60 degrees, so cos = .5 everywhere and all
// reflect the background, <.8, .4, .2>.
//   { .1, .9 falloff 2 }: .1 + .8 * .25 = .3: <.24, .12, .06>
//   { 0, 1 fresnel }, ior 1.5: sin t = .866025/1.5, cos t = .816497;
//       rs = (.5 - 1.5 * .816497)/(.5 + 1.5 * .816497) = -.420204,
//       rp = (1.5 * .5 - .816497)/(1.5 * .5 + .816497) = -.042449;
//       F = (rs^2 + rp^2)/2 = .0891867: <.0713494, .0356747, .0178373>
//   { .5 exponent 2 }: .5 * I^(1/2) = <.447214, .316228, .223607>
//   { .6 metallic .5 }: x = 60/90, F = .014567225/(x - 1.12)^2 - .011612903
//       = .0592700; times 1 + .5 (1 - F)(p - 1) with p = <1, .5, 0>:
//       1, .764818, .529635: <.48, .183556, .0635562>
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
background { rgb <.8, .4, .2> }
#default { pigment { rgb <1, .5, 0> } finish { ambient 0 diffuse 0 } }
#macro Mirror(Top, F)
    box { <-20, -.5, 0>, <20, .5, .1> finish { F } interior { ior 1.5 }
        rotate 60*y translate Top*y }
#end
Mirror(1.65, finish { reflection { .1, .9 falloff 2 } })
Mirror(.55, finish { reflection { 0, 1 fresnel } })
Mirror(-.55, finish { reflection { .5 exponent 2 } })
Mirror(-1.65, finish { reflection { .6 metallic .5 } })
