// Every macro of povray-includes that gives a value: beside what POV-Ray gives.
#version 3.7;
#include "rad_def.inc"
global_settings { assumed_gamma 1 radiosity { Rad_Settings(Radiosity_Debug, off, off) } }
#include "arrays.inc"
#include "colors.inc"
#include "debug.inc"
#include "functions.inc"
#include "glass.inc"
#include "ior.inc"
#include "math.inc"
#include "meshmaker.inc"
#include "rand.inc"
#include "shapes.inc"
#include "strings.inc"
#include "sunpos.inc"
#include "transforms.inc"
#declare Stream1 = seed(7);
#macro ShowN(Name, Value) #debug concat("value ", Name, " ", str(Value, 0, 6), "\n") #end
#macro ShowV(Name, Value) #debug concat("value ", Name, " ", vstr(3, Value, ",", 0, 6), "\n") #end
#macro Show5(Name, Value) #debug concat("value ", Name, " ", vstr(5, Value, ",", 0, 6), "\n") #end
#macro ShowT(Name, Value) #debug concat("value ", Name, " ", Value, "\n") #end
#macro ShowA(Name, Arr) #local Count = 0; #while (Count < dimension_size(Arr, 1)) ShowN(Name, Arr[Count]) #local Count = Count + 1; #end #end
// arrays.inc
#declare Five = array[5] { 5, 3, 9, 1, 7 }

#declare Probe = sphere { 0, Rand_Array_Item(Five, Stream1) }
#declare Got = max_extent(Probe);
ShowV("Rand_Array_Item", Got)
#declare Longer = array[5] { 5, 3, 9, 1, 7 }
Resize_Array(Longer, 7)

#declare Got = dimension_size(Longer, 1); ShowN("Resize_Array", Got)
Reverse_Array(Five) ShowA("Reverse_Array", Five)

#declare Got = Sort_Compare(Five, 0, 1); ShowN("Sort_Compare", Got)
Sort_Swap_Data(Five, 0, 2) ShowA("Sort_Swap_Data", Five)
Sort_Partial_Array(Five, 1, 3) ShowA("Sort_Partial_Array", Five)
Sort_Array(Five) ShowA("Sort_Array", Five)
#declare Many = array[40];
#declare Count = 0; #while (Count < 40) #declare Many[Count] = mod(Count*17, 40); #declare Count = Count + 1; #end
Sort_Array(Many) ShowA("Sort_Array", Many)
#declare Dense = array[2][2][2] { { { 0, .2 }, { .4, .6 } }, { { .8, 1 }, { .5, .1 } } }
ARRAYS_WriteDF3(Dense, "macros.df3", 8)
#declare Read = function { pattern { density_file df3 "macros.df3" } }

#declare Got = Read(.3, .4, .8); ShowN("ARRAYS_WriteDF3", Got)
// colors.inc

#declare Got = CH2RGB(200); ShowV("CH2RGB", Got)
#declare Got = CRGB2H(<.2, .5, .9>, .9, .7); ShowN("CRGB2H", Got)

#declare Got = CHSL2RGB(<200, .5, .4, .1, .2>); Show5("CHSL2RGB", Got)
#declare Got = CRGB2HSL(rgbft <.2, .5, .9, .1, .2>); Show5("CRGB2HSL", Got)

#declare Got = CHSV2RGB(<200, .5, .4, .1, .2>); Show5("CHSV2RGB", Got)
#declare Got = CRGB2HSV(rgbft <.2, .5, .9, .1, .2>); Show5("CRGB2HSV", Got)
// debug.inc
Debug_Inc_Stack() Set_Debug(true) Debug_Message("value Debug_Message\n") Debug((1 > 2), "value Debug: never\n") Debug((2 > 1), "value Debug\n")
Warning(false, "never") Error(false, "never")
// functions.inc, ior.inc

#declare Got = eval_pigment(pigment { gradient x }, <.3, 0, 0>); ShowV("eval_pigment", Got)
// math.inc

#declare Got = Mean(Five); ShowN("Mean", Got)
#declare Got = Std_Dev(Five, Mean(Five)); ShowN("Std_Dev", Got)
GetStats(Five) ShowA("GetStats", StatisticsArray)
#declare Got = Interpolate(.3, 0, 1, 5, 9, 0); ShowN("Interpolate", Got)
#declare Got = Interpolate(.3, 0, 1, 5, 9, 2); ShowN("Interpolate", Got)
#declare PointP = <1, 2, -3>; #declare PointQ = <.5, -1, 2>; #declare P5 = rgbft <1, 2, 3, 4, 5>; 

#declare Got = VSqr(PointP); ShowV("VSqr", Got)
#declare Got = VPow(<1, 2, 3>, 1.5); ShowV("VPow", Got)
#declare Got = VPow5D(P5, 2); Show5("VPow5D", Got)

#declare Got = VEq(PointP, PointQ); ShowN("VEq", Got)
#declare Got = VEq5D(P5, P5); ShowN("VEq5D", Got)
#declare Got = VZero(<0, 0, 0>); ShowN("VZero", Got)
#declare Got = VZero5D(P5); ShowN("VZero5D", Got)

#declare Got = VLength5D(P5); ShowN("VLength5D", Got)
#declare Got = VNormalize5D(P5); Show5("VNormalize5D", Got)
#declare Got = VDot5D(P5, P5); ShowN("VDot5D", Got)

#declare Got = VCos_Angle(PointP, PointQ); ShowN("VCos_Angle", Got)
#declare Got = VAngle(PointP, PointQ); ShowN("VAngle", Got)
#declare Got = VAngleD(PointP, PointQ); ShowN("VAngleD", Got)

#declare Got = VRotation(x, y, z); ShowN("VRotation", Got)
#declare Got = VRotationD(x, y, -z); ShowN("VRotationD", Got)
#declare Got = VDist(PointP, PointQ); ShowN("VDist", Got)

#declare Got = VPerp_To_Vector(PointP); ShowV("VPerp_To_Vector", Got)
#declare Got = VPerp_To_Plane(PointP, PointQ); ShowV("VPerp_To_Plane", Got)
#declare Got = VPerp_Adjust(PointP, PointQ); ShowV("VPerp_Adjust", Got)

#declare Got = VProject_Plane(PointP, PointQ); ShowV("VProject_Plane", Got)
#declare Got = VProject_Axis(PointP, PointQ); ShowV("VProject_Axis", Got)

#declare Got = VMin(PointP); ShowN("VMin", Got)
#declare Got = VMax(PointP); ShowN("VMax", Got)
#declare Got = VWith_Len(PointP, 3); ShowV("VWith_Len", Got)
#declare Bowl = function(x, y, z) { x*x + y*z - sin(x*y) }
#declare Slope = function(x, y, z) { x - y*y }
SetGradientAccuracy(.001)
#declare Steep = fn_Gradient(Bowl) #declare Along = fn_Gradient_Directional(Bowl, <1, 2, 0>) #declare Out = fn_Divergence(Bowl, Slope, Bowl)

#declare Got = Steep(.2, .3, .4); ShowN("fn_Gradient", Got)
#declare Got = Along(.2, .3, .4); ShowN("fn_Gradient_Directional", Got)
#declare Got = Out(.2, .3, .4); ShowN("fn_Divergence", Got)

#declare Got = vGradient(Bowl, <.2, .3, .4>); ShowV("vGradient", Got)
#declare Got = vCurl(Bowl, Slope, Bowl, <.2, .3, .4>); ShowV("vCurl", Got)

#declare Got = Divergence(Bowl, Slope, Bowl, <.2, .3, .4>); ShowN("Divergence", Got)
#declare Got = Gradient_Length(Bowl, <.2, .3, .4>); ShowN("Gradient_Length", Got)

#declare Got = Gradient_Directional(Bowl, <.2, .3, .4>, y); ShowN("Gradient_Directional", Got)
// meshmaker.inc

#declare Got = LInterpolate(.3, 2, 5); ShowN("LInterpolate", Got)
#declare Got = CheckFileName(""); ShowN("CheckFileName", Got)

#declare Got = FromU(.5); ShowN("FromU", Got)
#declare Got = ToU(.5); ShowN("ToU", Got)
#declare Got = FromV(.5); ShowN("FromV", Got)
#declare Got = ToV(.5); ShowN("ToV", Got)
#declare Way = BuildSpline(array[4] { x, y, z, x + y }, "C")

#declare Got = Way(.4); ShowV("BuildSpline", Got)
// rand.inc

#declare Got = Prob(.5, Stream1); ShowN("Prob", Got)
#declare Got = Rand_Cauchy(0, 1, Stream1); ShowN("Rand_Cauchy", Got)
#declare Got = Rand_Student(3, Stream1); ShowN("Rand_Student", Got)
#declare Got = Rand_Normal(0, 1, Stream1); ShowN("Rand_Normal", Got)

#declare Got = Rand_Gauss(0, 1, Stream1); ShowN("Rand_Gauss", Got)
#declare Probe = sphere { Rand_Spline(Way, Stream1), 1 }
#declare Got = max_extent(Probe);
ShowV("Rand_Spline", Got)
#declare Got = Rand_Gamma(2, 1, Stream1); ShowN("Rand_Gamma", Got)
#declare Got = Rand_Beta(2, 3, Stream1); ShowN("Rand_Beta", Got)

#declare Got = Rand_Chi_Square(3, Stream1); ShowN("Rand_Chi_Square", Got)
#declare Got = Rand_F_Dist(2, 3, Stream1); ShowN("Rand_F_Dist", Got)
#declare Got = Rand_Triangle(0, 2, 1, Stream1); ShowN("Rand_Triangle", Got)

#declare Got = Rand_Erlang(1, 2, Stream1); ShowN("Rand_Erlang", Got)
#declare Got = Rand_Exp(2, Stream1); ShowN("Rand_Exp", Got)
#declare Got = Rand_Lognormal(0, 1, Stream1); ShowN("Rand_Lognormal", Got)
#declare Got = Rand_Pareto(2, Stream1); ShowN("Rand_Pareto", Got)

#declare Got = Rand_Weibull(2, 1, Stream1); ShowN("Rand_Weibull", Got)
#declare Got = Rand_Bernoulli(.5, Stream1); ShowN("Rand_Bernoulli", Got)
#declare Got = Rand_Binomial(9, .5, Stream1); ShowN("Rand_Binomial", Got)
#declare Got = Rand_Geo(.3, Stream1); ShowN("Rand_Geo", Got)

#declare Got = Rand_Poisson(3, Stream1); ShowN("Rand_Poisson", Got)
#declare Got = SRand(Stream1); ShowN("SRand", Got)
#declare Got = RRand(2, 3, Stream1); ShowN("RRand", Got)
#declare Got = VRand(Stream1); ShowV("VRand", Got)
#declare Got = VRand_In_Box(-1, <2, 3, 4>, Stream1); ShowV("VRand_In_Box", Got)

#declare Got = VRand_In_Sphere(Stream1); ShowV("VRand_In_Sphere", Got)
#declare Got = VRand_On_Sphere(Stream1); ShowV("VRand_On_Sphere", Got)
#declare Got = VRand_In_Obj(sphere { 0, 1 }, Stream1); ShowV("VRand_In_Obj", Got)
// shapes.inc
#declare Place = <0, 0, 0>; #declare Facing = <0, 0, 0>; #declare Ball = sphere { 0, 1 }

#declare Got = Isect(<0, .5, -5>, z, Ball, Place); ShowN("Isect", Got)
#declare Got = Place; ShowV("Isect", Got)

#declare Got = IsectN(<0, .5, -5>, z, Ball, Place, Facing); ShowN("IsectN", Got)
#declare Got = Facing; ShowV("IsectN", Got)
#declare Low = 0; #declare High = 0; Extents(Ball, Low, High)
#declare Got = Low; ShowV("Extents", Got)
#declare Got = High; ShowV("Extents", Got)

#declare Got = Text_Space("timrom.ttf", "wide", 1, .1);
ShowN("Text_Space", Got)
#declare Got = Text_Width("timrom.ttf", "wide", 1, .1); ShowN("Text_Width", Got)
// strings.inc

#declare Got = CRGBFTStr(P5, 0, 3); ShowT("CRGBFTStr", Got)
#declare Got = CRGBStr(P5, 0, 3); ShowT("CRGBStr", Got) Parse_String("#declare Parsed = 3;")
#declare Got = Parsed; ShowN("Parse_String", Got)

#declare Got = Str(1.25); ShowT("Str", Got)
#declare Got = VStr2D(<1, 2>); ShowT("VStr2D", Got)
#declare Got = VStr(<1, 2, 3>); ShowT("VStr", Got)
#declare Got = Vstr2D(<1, 2>, 0, 2); ShowT("Vstr2D", Got)
#declare Got = Vstr(<1, 2, 3>, 0, 2); ShowT("Vstr", Got)

#declare Got = substr(Triangle_Str(x, y, z), 1, 40); ShowT("Triangle_Str", Got)
#declare Got = substr(Smooth_Triangle_Str(x, x, y, y, z, z), 1, 40); ShowT("Smooth_Triangle_Str", Got)
// sunpos.inc, transforms.inc

#declare Got = SunPos(2000, 6, 21, 12, 30, 0, 51.5, 10); ShowV("SunPos", Got)

#declare Got = vtransform(PointP, transform { rotate 30*y translate x }); ShowV("vtransform", Got)
#declare Got = vinv_transform(PointP, transform { rotate 30*y translate x }); ShowV("vinv_transform", Got)

#declare Got = vtransform(PointP, Shear_Trans(x, y + x, z)); ShowV("Shear_Trans", Got)
#declare Got = vtransform(PointP, Matrix_Trans(x, z, y, x)); ShowV("Matrix_Trans", Got)

#declare Got = vtransform(PointP, Axial_Scale_Trans(<1, 1, 0>, 2)); ShowV("Axial_Scale_Trans", Got)
#declare Got = vtransform(PointP, Axis_Rotate_Trans(<1, 1, 0>, 30)); ShowV("Axis_Rotate_Trans", Got)

#declare Got = vtransform(PointP, Rotate_Around_Trans(30*y, x)); ShowV("Rotate_Around_Trans", Got)
#declare Got = vtransform(PointP, Reorient_Trans(x, <1, 2, 3>)); ShowV("Reorient_Trans", Got)

#declare Got = vtransform(PointP, Point_At_Trans(<1, 2, 3>)); ShowV("Point_At_Trans", Got)
#declare Got = vtransform(PointP, Center_Trans(Ball, x)); ShowV("Center_Trans", Got)

#declare Got = vtransform(PointP, Align_Trans(Ball, x, 3*x)); ShowV("Align_Trans", Got)
#declare Got = vtransform(PointP, Spline_Trans(Way, .4, y, .1, .5)); ShowV("Spline_Trans", Got)
camera { location -5*z look_at 0 }
