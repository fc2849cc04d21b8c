// Every macro of povray-includes that makes something to see: beside POV-Ray's picture.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#include "functions.inc"
#include "glass.inc"
#include "meshmaker.inc"
#include "makegrass.inc"
#include "rand.inc"
#include "shapes.inc"
#include "shapes3.inc"
#include "textures.inc"
#include "transforms.inc"
#include "screen.inc"
Reset_Camera() Set_Camera_Aspect(4, 3) Set_Camera_Aspect_Ratio(4/3) Set_Camera_Sky(y) Set_Camera_Zoom(1)
Set_Camera_Angle(40) Set_Camera_Location(-20*z) Set_Camera_Look_At(0) Set_Camera(<0, 0, -30>, 0, 40)
Screen_Object(sphere { 0, .03 pigment { rgb 1 } finish { ambient 1 } }, <0, 0>, <.02, .02>, true, .01)
Screen_Plane(texture { pigment { rgb y } finish { ambient 1 } }, .01, <.96, .96>, <1, 1>)
light_source { <-50, 80, -60>, rgb 1 }
#default { pigment { rgb <.8, .6, .4> } finish { ambient .2 phong .3 } }
#declare Column = 0;
// Fits an object into the next place.
#macro Put(Object)
    #local Low = min_extent(Object); #local High = max_extent(Object); #local Size = vlength(High - Low);
    object { Object translate -(Low + High)/2 rotate <-25, 20, 0> scale 1.8/min(max(Size, .01), 1000)
        translate <mod(Column, 11)*1.9 - 9.5, 7.2 - 1.9*int(Column/11), 0> }
    #declare Column = Column + 1;
#end
// shapes.inc
#declare Thing = object { Center_Object(box { 0, <1, 2, 3> }, x) } Put(Thing)
#declare Thing = object { Align_Object(box { 0, <1, 2, 3> }, y, 2*y) } Put(Thing)
#declare Cuts = 4; #declare Thing = object { Bevelled_Text("timrom.ttf", "B", 4, 35, .04, .3, .05, 0) } Put(Thing)

#declare Thing = object { Circle_Text("timrom.ttf", "round", 1, .1, .2, 2, 0, Align_Center, -90) } Put(Thing)
#declare Thing = object { Circle_Text_Valigned("timrom.ttf", "round", 1, .1, .2, 2, 0, Align_Left, 0, 0) }
Put(Thing)
#declare Thing = intersection { sphere { 0, 1 } object { Wedge(70) } } Put(Thing)
#declare Thing = object { Spheroid(<0, 0, 0>, <1, .5, .7>) } Put(Thing)
#declare Thing = object { Supertorus(1, .3, .5, .7, .01, 2) } Put(Thing)
#declare Thing = object { Supercone(0, .5, .8, 2*y, .3, .2) } Put(Thing)
#declare Thing = union { object { Connect_Spheres(0, .5, 2*y, .2) } sphere { 0, .5 } sphere { 2*y, .2 } } Put(Thing)
#declare From = <-1, -.6, -1>; #declare To = <1, .6, 1>;
#declare Thing = object { Wire_Box_Union(From, To, .1) } Put(Thing)
#declare Thing = object { Wire_Box_Merge(From, To, .1) } Put(Thing)
#declare Thing = object { Wire_Box(From, To, .1, true) } Put(Thing)
#declare Thing = object { Round_Box_Union(From, To, .2) } Put(Thing)
#declare Thing = object { Round_Box_Merge(From, To, .2) } Put(Thing)
#declare Thing = object { Round_Box(From, To, .2, true) } Put(Thing)
#declare Thing = object { Round_Cylinder_Union(0, y, .6, .1) } Put(Thing)
#declare Thing = object { Round_Cylinder_Merge(0, y, .6, .1) } Put(Thing)
#declare Thing = object { Round_Cylinder(0, y, .6, .1, false) } Put(Thing)
#declare Thing = object { Round_Cone_Union(0, .7, y, .4, .1) } Put(Thing)
#declare Thing = object { Round_Cone_Merge(0, .7, y, .4, .1) } Put(Thing)
#declare Thing = object { Round_Cone(0, .7, y, .4, .1, true) } Put(Thing)
#declare Thing = object { Round_Cone2_Union(0, .7, y, .4) } Put(Thing)
#declare Thing = object { Round_Cone2_Merge(0, .7, y, .4) } Put(Thing)
#declare Thing = object { Round_Cone2(0, .7, y, .4, false) } Put(Thing)
#declare Thing = object { Round_Cone3_Union(0, .7, y, .4) } Put(Thing)
#declare Thing = object { Round_Cone3_Merge(0, .7, y, .4) } Put(Thing)
#declare Thing = object { Round_Cone3(0, .7, y, .4, false) } Put(Thing)
#declare Thing = mesh { Quad(0, x, x + y, y) Smooth_Quad(0, x - z, -y, y - z, -y - x, -z, -x, -z) } Put(Thing)
#declare Hills = function(x, y, z) { f_noise3d(x*4, y*4, z*4) }
#declare Thing = object { HF_Square(Hills, 0, 0, 12, 0, "", <-1, 0, -1>, <1, .5, 1>) } Put(Thing)
#declare Thing = object { HF_Sphere(Hills, 0, 0, 12, 1, "", 0, 1, .5) } Put(Thing)
#declare Thing = object { HF_Cylinder(Hills, 0, 0, <12, 8>, 1, "", 0, y, .6, .5) } Put(Thing)
#declare Thing = object { HF_Torus(Hills, 1, 0, <14, 10>, 1, "", 1, .4, .4) } Put(Thing)
// shapes3.inc
#declare Thing = object { Segment_of_Object(sphere { 0, 1 }, 250) } Put(Thing)
#declare Thing = object { Segment_of_CylinderRing(1, .6, .5, 200) } Put(Thing)
#declare Thing = object { Segment_of_Torus(1, .3, -130) } Put(Thing)
#declare Thing = object { Round_N_Tube_Polygon(5, .1, .5, .2, 0, 0) } Put(Thing)
#declare Thing = object { Pyramid_N(5, 1, .4, 1.2) } Put(Thing)
#declare Thing = object { Pyramid_N_AB(4, 0, .8, <1, 1, 0>, .3) } Put(Thing)
#declare Thing = object { Column_N(6, .4, 1) } Put(Thing)
#declare Thing = object { Column_N_AB(5, 0, <1, 1, 0>, .3) } Put(Thing)
#declare Thing = object { Egg_Shape(1.1, 1.5) } Put(Thing)
#declare Thing = object { Facetted_Sphere(4, 8) } Put(Thing)
#declare Thing = object { Facetted_Egg_Shape(4, 9, 1.1, 1.5) } Put(Thing)
#declare Thing = object { Facetted_Egg(4, 8) } Put(Thing)
#declare Thing = object { Ring_Sphere(1, 1, .05, .05, 5, 6) } Put(Thing)
#declare Thing = object { Round_Pyramid_N_in(4, 0, .6, y, .2, .08, 1, 0) } Put(Thing)
#declare Thing = object { Round_Pyramid_N_out(5, 0, .6, y, .2, .08, 0, 0) } Put(Thing)
#declare Thing = object { Rounded_Tube(1, .7, .1, .6, 0) } Put(Thing)
#declare Thing = object { Rounded_Tube_AB(0, <1, .5, 0>, .4, .2, .05, 0) } Put(Thing)
#declare Thing = object { Round_Cylinder_Tube(0, y, .5, .1, 0, 0) } Put(Thing)
#declare Thing = object { Round_Conic_Torus(1.2, .2, .6, .1, 0) } Put(Thing)
#declare Thing = object { Round_Conic_Prism(1.2, .2, .6, .5, .08, 0) } Put(Thing)
#declare Thing = object { Half_Hollowed_Rounded_Cylinder1(2, .6, .1, 1, 0) } Put(Thing)
#declare Thing = object { Half_Hollowed_Rounded_Cylinder2(2, .6, .3, .1, 1, 0) } Put(Thing)
// meshmaker.inc
#declare Wave = spline { natural_spline -.5, <.4, -.2, 0> 0, <.6, 0, 0> .5, <.3, .5, 0> 1, <.7, 1, 0> 1.5, <.2, 1.2, 0> }
#declare Bow = spline { natural_spline -.5, <.4, 0, .6> 0, <.6, 0, 0> .5, <.3, .5, .4> 1, <.7, 1, 0> 1.5, <.2, 1.2, 0> }
#declare Rows = array[5];
#for (I, 0, 4) #declare Rows[I] = spline { linear_spline -.5, <.5, -.4, I - .1> 0, <.6 + I/9, 0, I> .5, <.7, .5, I + .3> 1, <.3, 1, I> 1.5, <.1, 1.5, I> } #end
#declare Thing = object { MSM(Rows, 8, "linear", 6, "") } Put(Thing)
#declare FX = function(u, v) { u*cos(v) } #declare FY = function(u, v) { sin(u*3)/3 } #declare FZ = function(u, v) { u*sin(v) }
#declare Thing = object { Parametric(FX, FY, FZ, <.2, 0>, <1, 5>, 12, 12, "") } Put(Thing)
#declare __F1 = function(u, v) { FX(u, v) }
#declare Thing = object { Prism(Bow, 10, .4, 3, "") } Put(Thing)
#declare Thing = object { Prism1(Bow, 10, Wave, 5, "") } Put(Thing)
#declare Thing = object { Lathe(Wave, 10, 300, 12, "") } Put(Thing)
#declare Edge1 = spline { linear_spline 0, 0 1, 2*x } #declare Edge2 = spline { linear_spline 0, 2*x 1, 2*x + 2*z }
#declare Edge3 = spline { linear_spline 0, 2*z 1, 2*x + 2*z } #declare Edge4 = spline { quadratic_spline 0, 0 .5, y + z 1, 2*z }
#declare Thing = object { Coons(Edge1, Edge2, Edge3, Edge4, 6, 6, "") } Put(Thing)
#declare Bumps = function(x, y) { sin(x*4)*cos(y*3)/3 }
#declare Thing = object { TwoVarSurf(Bumps, <-1, 1>, <-1, 1>, 10, 10, "") } Put(Thing)
#declare Track = function { spline { natural_spline -.2, -z 0, 0 .5, <1, 1, 1> 1, <2, 0, 0> 1.2, <2.5, 0, 1> } }
#declare Ring = function { spline { cubic_spline -.25, -.3*y 0, .3*x .25, .3*y .5, -.3*x .75, -.3*y 1, .3*x 1.25, .3*y } }
#declare Waist = function { spline { linear_spline 0, 1 1, .5 } }
#declare Thing = object { SweepSpline1(Track, Ring, Waist, 12, 8, "") } Put(Thing)
#declare Thing = object { SweepSpline2(Track, Ring, Waist, 12, 8, "") } Put(Thing)
// makegrass.inc
#declare Thing = mesh { MakeBlade(1, <0, 0, 0>, 20, 5, 10, 1, .1, .5, <0, 1, .3>, <0, 0, 1>, 1, 1, 0) } Put(Thing)
#declare Thing = object { MakeGrassPatch(10, 3, 60, 4, 6, 1, .3, 0, <0, 1, .3>, <0, -1, 2>, 3, 18, .3, 100, 1, 0, 0, 0, "") } Put(Thing)
#declare Sward = Thing
#declare Thing = object { MakePrairie(10, 2, 1, 2, Sward, 7, 1, 1, 0) } Put(Thing)
// textures.inc, glass.inc
#declare Thing = sphere { 0, 1 hollow pigment { rgbf <.8, 1, .9, .9> } interior { I_Glass_Exp(2) fade_color rgb .5 } } Put(Thing)
#declare Thing = sphere { 0, 1 hollow pigment { rgbf <.8, 1, .9, .9> } interior { I_Glass_Sqr(2) fade_color rgb .5 } } Put(Thing)
#declare Thing = box { -1, <1, 1, .2> pigment { Irregular_Bricks_Ptrn(.1, 1, .5, .2) scale .4 } } Put(Thing)
#declare Thing = box { -1, <1, 1, .2> pigment { Hex_Tiles_Ptrn() scale .4 } } Put(Thing)
#declare Thing = box { -1, <1, 1, .2> pigment { Tiles_Ptrn() scale .4 } } Put(Thing)
#declare Thing = box { -1, <1, 1, .2> pigment { Star_Ptrn(.5, 5, 2) } } Put(Thing)
