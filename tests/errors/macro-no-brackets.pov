#macro A P, Q sphere { P, Q } #end
