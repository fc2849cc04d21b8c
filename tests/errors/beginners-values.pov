// What beginners write where a value is wanted.
#while (Round < 3) #declare Round = Round + 1; #end
sphere { 0, 1 pigment { colour Rgb <1, 0, 0> } }
#declare Place = <1, 2, 3>;
sphere { Place[0], 1 }
text { "Hello" }
sphere { 0, 1 pigment { checker rgb 0 rgb 1 rgb 0.5 } }
sphere { <-1 -1 -1>, 1 }
