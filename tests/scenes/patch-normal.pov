// The normal that trace() finds on a patch is POV-Ray's.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -5> look_at 0 }
light_source { <-5, 8, -6>, 1 }
#declare P = bicubic_patch { u_steps 4 v_steps 4,
    <-4,-4,2>, <-2,-4,0>, <2,-4,0>, <4,-4,2>
    <-4,-2,0>, <-2,-2,-1>, <2,-2,-1>, <4,-2,0>
    <-4,2,0>, <-2,2,-1>, <2,2,-1>, <4,2,0>
    <-4,4,2>, <-2,4,0>, <2,4,0>, <4,4,2> pigment { rgb 1 } }
#declare N = <0, 0, 0>;
#declare T = trace(P, <0.1, 0.2, -5>, z, N);
#debug concat(vstr(3, N, ",", 0, 4), "\n")
object { P }
