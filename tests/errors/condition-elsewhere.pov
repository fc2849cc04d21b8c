#macro M() 1) #end
#for (I, 0, M() 
#end
sphere {0 1}
