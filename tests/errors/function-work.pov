#declare F = function(x, y, z) { x + y };
#for (I, 1, 30)
  #declare F = function(x, y, z) { F(x, y, z) + F(z, y, x) };
#end
#declare P = pigment { wood };
#for (I, 1, 40)
  #declare P = pigment { pigment_pattern { P } };
#end
#declare G = function { pattern { wood } };
#for (I, 1, 40)
  #declare Q = pigment { function { G(x, y, z) } };
  #declare H = function { pigment { Q } };
  #declare G = function { H(x, y, z).gray };
#end
