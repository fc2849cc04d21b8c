#version 3.7;
#macro A(X) X #end
#macro N() A #end
sphere { 0, N()(bozo, 2) }
sphere { 0, N()(1) }
#macro M() A(bozo #end
sphere{0,M(),3}sphere { 0, foo }
