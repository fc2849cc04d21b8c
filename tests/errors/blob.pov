blob { threshold .5 }
blob { threshold -1 sphere { 0, 1, 1 } }
blob { sphere { 0, 0, 1 } }
blob { sphere { 0, 1, 1 colour 1 } }
