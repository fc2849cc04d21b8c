// hollow: an interior is as hollow as the last part that shares it, whatever
// the others and the object say, unless that is hollow as a whole.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z look_at 0 right 10*x up 7.5*y }
background { rgb <0, 0, .2> }
#default { finish { ambient 1 diffuse 0 } }
object { union { sphere{0,1 hollow pigment { rgbt 1 } interior { media { emission .5 method 3 } }} box{<2,0,0>,2.1} } translate <-3.6, 1.5, 0> }
object { union { sphere{0,1 hollow pigment { rgbt 1 } interior { media { emission .5 method 3 } }} sphere{0,.3 pigment { rgbt 1 }} } translate <-1.2, 1.5, 0> }
object { intersection { sphere{0,1 hollow} box{-1,.8 hollow} pigment { rgbt 1 } interior { media { emission .5 method 3 } } } translate <1.2, 1.5, 0> }
object { intersection { sphere{0,1 hollow} box{-1,.8} pigment { rgbt 1 } interior { media { emission .5 method 3 } } } translate <3.6, 1.5, 0> }
object { intersection { box{-1,.8} sphere{0,1 hollow} pigment { rgbt 1 } interior { media { emission .5 method 3 } } } translate <-3.6, -1.5, 0> }
object { intersection { box{-1,.8} sphere{0,1} hollow pigment { rgbt 1 } interior { media { emission .5 method 3 } } } translate <-1.2, -1.5, 0> }
object { merge { sphere{0,.8 hollow} sphere{.4*x,.6} pigment { rgbt 1 } interior { media { emission .5 method 3 } } } translate <1.2, -1.5, 0> }
object { union { union { sphere{0,1 hollow pigment { rgbt 1 } interior { media { emission .5 method 3 } }} } hollow off } translate <3.6, -1.5, 0> }
