#for (I, 0, 1e9) sphere { I*x, 1 } #end
