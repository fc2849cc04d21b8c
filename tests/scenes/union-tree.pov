// A union of many is asked by way of a tree. It answers as the same objects do
// in unions of 15, which have none.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare R = seed(7);
#macro V(Size) <rand(R) - 0.5, rand(R) - 0.5, rand(R) - 0.5>*Size #end
#declare Pieces = array[15*15];
#for (I, 0, 15*15 - 1)
  #switch (mod(I, 9))
  #case (0) #declare Pieces[I] = sphere { V(20), rand(R) } #break
  #case (1) #declare Pieces[I] = box { -0.5, 0.5 rotate V(360) translate V(20) } #break
  #case (2)
    #declare Pieces[I] =
      difference { sphere { 0, 1 } box { 0, 2 } rotate V(360) translate V(20) }
    #break
  #case (3)
    #declare Pieces[I] =
      mesh { triangle { V(2), V(2), V(2) } triangle { V(2), V(2), V(2) } translate V(20) }
    #break
  #case (4) #declare Pieces[I] = torus { 0.6, 0.2 rotate V(360) translate V(20) } #break
  #case (5)
    #declare Pieces[I] =
      sphere { 0, 1 clipped_by { box { 0, 2 } } rotate V(360) translate V(20) }
    #break
  #case (6) #declare Pieces[I] = sphere { V(4), 1.5 bounded_by { sphere { 100, 0.1 } } } #break
  #case (7) #declare Pieces[I] = sphere { <1, 2, 3>, 1 } #break
  #case (8) #declare Pieces[I] = blob { threshold 0.5 sphere { V(20), 1, 1 } } #break
  #end
#end
#macro Compare(Many, Few, Name)
  #local Hits = 0;
  #local Insides = 0;
  #for (I, 1, 400)
    #local P = V(30);
    #local D = V(2);
    #local N1 = <0, 0, 0>;
    #local N2 = <0, 0, 0>;
    #local T1 = trace(Many, P, D, N1);
    #local T2 = trace(Few, P, D, N2);
    #local Hits = Hits + (vlength(N1) > 0);
    #if (vlength(T1 - T2) + vlength(N1 - N2) > 0)
      #error concat(Name, " is met elsewhere\n")
    #end
    #local P = V(8);
    #local Insides = Insides + inside(Many, P);
    #if (inside(Many, P) != inside(Few, P)) #error concat(Name, ": inside\n") #end
  #end
  #debug concat(Name, ": ", str(Hits, 0, 0), " hits, ", str(Insides, 0, 0), " inside\n")
#end
#declare Union = union { #for (I, 0, 224) object { Pieces[I] } #end }
#declare Groups =
  union { #for (G, 0, 14) union { #for (I, 0, 14) object { Pieces[15*G + I] } #end } #end }
Compare(Union, Groups, "union")
Compare(object { Union rotate 30*y scale 0.5 }, object { Groups rotate 30*y scale 0.5 }, "moved")
#declare Merge = merge { #for (I, 0, 224) object { Pieces[I] } #end }
#declare Merges =
  merge { #for (G, 0, 14) merge { #for (I, 0, 14) object { Pieces[15*G + I] } #end } #end }
Compare(Merge, Merges, "merge")
Compare(difference { box { -6, 6 } object { Union } },
        difference { box { -6, 6 } object { Groups } }, "cut")
Compare(object { Union inverse }, object { Groups inverse }, "inverse")
