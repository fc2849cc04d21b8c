#declare Ball = sphere { 0, 1 }
object { ball }
object { union { sphere { 0, 1 } } sphere { 0, 1 } }
#declare Foo == 3;
#declare Bar;
sphere { 0, 1 translate x y z }
#read (F, A)
sphere { 0, 1 wrong }
